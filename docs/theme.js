// Before the first paint: the colours that the reader chose here last time, or else those of the system.
(function () {
  'use strict';
  let chosen = null;
  try {
    chosen = localStorage.getItem('theme');
  } catch { /* a browser that keeps nothing for files */ }
  const system = matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light';
  document.documentElement.dataset.theme = chosen === 'dark' || chosen === 'light' ? chosen : system;
  document.documentElement.classList.add('with-js');

  // For the scripts that follow: the id a link leads to, or nothing if its escapes are broken, as in "#%".
  self.linkedId = () => {
    try {
      return decodeURIComponent(location.hash.slice(1));
    } catch {
      return '';
    }
  };
})();
