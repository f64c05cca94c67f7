// Loaded when the first log is dropped onto the page.
import text from 'worker:log_worker.js';

globalThis.rmeLogWorker = text;
