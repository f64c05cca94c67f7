// The last seconds of estimated and true mass, and how they are drawn.
const kSeconds = 12, kInterval = 0.02;

export class History {
  constructor() {
    this.clear();
  }
  clear() {
    this.rows = [];
  }
  add(get) {
    this.rows.push({t: get('ticks')[0] / 1000, mean: get('with.mean')[0], deviation: get('with.deviation')[0], truth: get('with.payload')[0]});
    if (this.rows.length > kSeconds / kInterval) this.rows.shift();
  }
}

/// Hatches, so that the band is one without colour as well.
const hatch = (() => {
  const tile = document.createElement('canvas');
  tile.width = tile.height = 6;
  const pen = tile.getContext('2d');
  pen.strokeStyle = '#1565c0';
  for (const from of [-6, 0, 6]) {
    pen.moveTo(from, 6);
    pen.lineTo(from + 6, 0);
  }
  pen.stroke();
  return pen.createPattern(tile, 'repeat');
})();

/// Draws rows {t, mean, deviation, truth} from `begin` to `end` [s]; truth may be missing.
export function drawRows(canvas, rows, begin, end) {
  const ratio = devicePixelRatio, width = canvas.clientWidth, height = canvas.clientHeight;
  if (canvas.width !== Math.round(width * ratio)) {
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
  }
  const pen = canvas.getContext('2d');
  pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  pen.clearRect(0, 0, width, height);
  const most = rows.reduce((m, row) => Math.max(m, row.mean + row.deviation, row.truth ?? 0), 0.5);
  const step = most > 10 ? 5 : most > 4 ? 2 : most > 2 ? 1 : 0.5, top = step * Math.ceil(1.05 * most / step);
  const x = (t) => 30 + (width - 34) * (t - begin) / (end - begin), y = (kg) => height - 16 - (height - 22) * Math.max(kg, 0) / top;
  pen.font = '11px system-ui, sans-serif';
  pen.fillStyle = '#5b6472';
  pen.strokeStyle = '#dde2e8';
  for (let kg = 0; kg <= top + 1e-9; kg += step) {
    pen.strokeRect(30, y(kg), width - 34, 0);
    pen.fillText(kg.toFixed(step < 1 ? 1 : 0), 4, y(kg) + 4);
  }
  const seconds = Math.max(1, Math.round((end - begin) / 6));
  for (let t = seconds * Math.ceil(begin / seconds); t <= end; t += seconds) pen.fillText(`${t} s`, Math.min(x(t) - 8, width - 26), height - 3);
  const line = (points, dash) => {
    pen.setLineDash(dash);
    pen.beginPath();
    for (const [t, kg] of points) pen.lineTo(x(t), y(kg));
  };
  const upper = rows.map((row) => [row.t, row.mean + 2 * row.deviation]), lower = rows.map((row) => [row.t, row.mean - 2 * row.deviation]);
  pen.save();
  pen.beginPath();
  pen.rect(30, 0, width - 34, height - 16);
  pen.clip();
  line([...upper, ...lower.reverse()], []);
  pen.fillStyle = hatch;
  pen.fill();
  pen.strokeStyle = '#1f2937';
  line(rows.filter((row) => row.truth !== undefined).map((row) => [row.t, row.truth]), [5, 4]);
  pen.stroke();
  pen.lineWidth = 2;
  pen.strokeStyle = '#1565c0';
  line(rows.map((row) => [row.t, row.mean]), []);
  pen.stroke();
  pen.restore();
  pen.setLineDash([]);
}

export function drawHistory(canvas, {rows}) {
  const end = Math.max(kSeconds, rows[rows.length - 1].t);
  drawRows(canvas, rows, end - kSeconds, end);
}
