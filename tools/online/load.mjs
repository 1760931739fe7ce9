// A file of the site; if it can't be had, why, for the reader: `what` is what it is to them.
export async function load(address, what) {
  const response = await fetch(address).catch(() => {
    throw new Error(`${what} isn’t kept in this browser yet, and the server can’t be reached`);
  });
  if (!response.ok) throw new Error(response.status === 404 ? 'the site has changed since this page was opened: reload it' : `the server can’t send ${what} (${response.status})`);
  return response;
}
