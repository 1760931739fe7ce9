// What a page has to do with the service worker (service_worker.mjs), which keeps the site.
import { make } from './elements.mjs';

const { serviceWorker } = navigator; // none where a browser keeps nothing, or the address isn't a safe one

// From the first check on. Where it can't be kept, it goes on as any site does.
export function keepSite(base) {
  if (!serviceWorker?.controller) serviceWorker?.register(new URL('../../service_worker.js', base)).catch(() => { /* then not */ });
}

// A new version waits until the page is reloaded. It's looked for whenever a reader comes back.
export function tellOfNewer() {
  const line = make('p', { className: 'newer' });
  line.setAttribute('role', 'status');
  document.body.append(line);
  serviceWorker?.addEventListener('message', () => (line.textContent = 'This book has a newer version: reload the page. Your code stays.'));
  document.addEventListener('visibilitychange', () => document.visibilityState === 'visible' && serviceWorker?.getRegistration().then((registration) => registration?.update()).catch(() => { /* no network */ }));
}
