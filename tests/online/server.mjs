// A static host on this machine, while the tests run.
import fs from 'node:fs';
import http from 'node:http';
import path from 'node:path';
import { after } from 'node:test';

const types = { '.html': 'text/html', '.js': 'text/javascript', '.css': 'text/css', '.json': 'application/json', '.svg': 'image/svg+xml', '.woff2': 'font/woff2' };

// Shows a folder, perhaps below a path; notes which files are asked for. `folder` may be a function, which says what is shown
// now: another version, or nothing, when the host is gone.
export async function serve(folder, asked = [], below = '') {
  const server = http.createServer(({ url, socket }, response) => {
    const now = typeof folder === 'function' ? folder() : folder;
    if (!now) return socket.destroy();
    const at = decodeURIComponent(new URL(url, 'http://host').pathname), name = at.slice(below.length + 1) || 'index.html', file = path.join(now, name);
    asked.push(name);
    if (!at.startsWith(`${below}/`) || !fs.existsSync(file)) return response.writeHead(404).end();
    response.writeHead(200, { 'content-type': types[path.extname(file)] ?? 'application/octet-stream', 'cache-control': 'no-cache' });
    fs.createReadStream(file).pipe(response);
  });
  await new Promise((done) => server.listen(0, '127.0.0.1', done));
  after(() => server.closeAllConnections() ?? server.close());
  return `http://127.0.0.1:${server.address().port}${below}`;
}
