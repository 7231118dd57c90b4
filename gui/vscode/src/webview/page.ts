/** The page of the robot panel. */
import { arms } from 'pendant:arms';
import type { Show, Wish } from '../panel/messages';
import type { RobotReading } from '../panel/reading';
import type { Stop } from '../panel/stops';
import { Scene } from './scene';
import type { Vector } from './matrix';

declare function acquireVsCodeApi(): { postMessage(wish: Wish): void };

const JOINTS = ['Base', 'Shoulder', 'Elbow', 'Wrist 1', 'Wrist 2', 'Wrist 3'];
const POSE = ['X', 'Y', 'Z', 'RX', 'RY', 'RZ'];
const OUTPUTS = new Set(['digital_out', 'configurable_out', 'tool_out']);
const TITLES: { readonly [name: string]: string } = {
  digital_in: 'DI',
  digital_out: 'DO',
  configurable_in: 'CI',
  configurable_out: 'CO',
  tool_in: 'TI',
  tool_out: 'TO',
  analog_in: 'Analog in',
  analog_out: 'Analog out',
  tool_analog_in: 'Tool analog in',
  robot_mode: 'Robot',
  safety_mode: 'Safety',
  safety_stop: 'Stop',
  tcp_speed: 'TCP speed',
  tcp_force: 'TCP force',
  speed_slider: 'Speed slider',
  payload: 'Payload',
};
const DEGREES = 180 / Math.PI;

const vscode = acquireVsCodeApi();
const main = document.querySelector('main') ?? document.body;
let shown: Show = { kind: 'show', state: 'none', stops: [] };
/** The stop that is looked at; undefined for the newest one. */
let selected: number | undefined;
let trail: readonly Vector[] = [];
let canvas: HTMLCanvasElement | undefined;
let scene: Scene | undefined;
let sceneArm = '';

window.addEventListener('message', (event: MessageEvent<Show>) => {
  if (event.data.stops.length !== shown.stops.length) {
    selected = undefined;
  }
  shown = event.data;
  trail = shown.stops.flatMap(({ reading: { tcp } }) => (tcp.length === 6 ? [tcp.slice(0, 3) as unknown as Vector] : []));
  build();
});
window.addEventListener('resize', paint);
new MutationObserver(paint).observe(document.body, { attributes: true, attributeFilter: ['class'] });
build();
vscode.postMessage({ kind: 'ready' });

function build(): void {
  const stop = shown.stops.find((each) => each.number === selected) ?? shown.stops[shown.stops.length - 1];
  if (stop === undefined) {
    canvas = undefined;
    scene = undefined;
    main.replaceChildren(
      element('p', 'hint', shown.state === 'running'
        ? 'The program runs. The robot is shown where it stops: at a breakpoint, or after Pause.'
        : 'Debug a program: the robot is shown here where it stops.'),
    );
    return;
  }
  main.replaceChildren(
    group('robot', view(stop.reading), status(stop)),
    joints(stop.reading),
    group('io', signals(stop), facts(stop.reading)),
    history(stop),
  );
  paint();
}

function view(reading: RobotReading): HTMLElement {
  const arm = arms[reading.arm.toLowerCase()] ?? arms['ur5e'];
  if (canvas === undefined || sceneArm !== reading.arm) {
    sceneArm = reading.arm;
    canvas = document.createElement('canvas');
    canvas.tabIndex = 0;
    canvas.setAttribute('role', 'img');
    scene = undefined;
    try {
      scene = arm === undefined ? undefined : new Scene(canvas, arm);
    } catch {
      // Without WebGL the numbers are there all the same.
    }
    handle(canvas);
  }
  canvas.setAttribute('aria-label', `${arm?.name ?? 'The arm'}, drag or press the arrow keys to turn it`);
  canvas.title = 'Drag or arrow keys: turn. Wheel, + and -: zoom.';
  const box = element('div', 'view');
  box.append(canvas, element('span', 'arm', arm?.name ?? reading.arm));
  return box;
}

function status(stop: Stop): HTMLElement {
  const box = element('div', 'status');
  const newest = shown.stops[shown.stops.length - 1] === stop;
  const words = !newest ? 'earlier stop' : shown.state === 'running' ? 'running since' : shown.state === 'ended' ? 'ended, last stop' : 'stopped';
  box.append(element('span', `badge ${newest ? shown.state : 'earlier'}`, words), element('span', 'time', stop.reading.time));
  if (stop.description !== '') {
    box.append(element('span', 'description', stop.description));
  }
  return box;
}

function joints({ joints: positions, tcp }: RobotReading): HTMLElement {
  const table = element('div', 'joints');
  positions.forEach((position, i) => {
    const bar = element('span', 'bar');
    const fill = element('span', position < 0 ? 'fill negative' : 'fill');
    fill.style.setProperty('--share', String(Math.min(1, Math.abs(position) / (2 * Math.PI))));
    bar.append(fill);
    table.append(element('span', 'name', JOINTS[i] ?? ''), bar, element('span', 'number', `${fixed(position * DEGREES, 1)}°`));
  });
  const pose = element('div', 'pose');
  tcp.forEach((each, i) => {
    const cell = element('span', 'cell');
    const text = i < 3 ? fixed(1000 * each, 1) : fixed(each, 3);
    cell.append(element('span', 'name', POSE[i] ?? ''), element('span', 'number', text));
    pose.append(cell);
  });
  pose.title = 'TCP in the base frame: mm, and the rotation vector in rad';
  const box = element('section', 'positions');
  box.append(table, pose);
  return box;
}

function signals(stop: Stop): HTMLElement {
  const box = element('section', 'signals');
  const now = shown.state === 'stopped' && shown.stops[shown.stops.length - 1] === stop;
  for (const bank of stop.reading.banks) {
    const row = element('div', 'bank');
    row.append(element('span', 'name', TITLES[bank.name] ?? bank.name));
    bank.on.forEach((on, i) => {
      const lamp = element('button', on ? 'lamp on' : 'lamp', String(i)) as HTMLButtonElement;
      lamp.title = `${bank.name}[${i}] is ${on ? 'on' : 'off'}`;
      lamp.setAttribute('aria-pressed', String(on));
      if (OUTPUTS.has(bank.name) && now) {
        lamp.title += `: switch it ${on ? 'off' : 'on'}`;
        lamp.onclick = () => vscode.postMessage({ kind: 'output', bank: bank.name, index: i, on: !on });
      } else {
        lamp.disabled = true;
      }
      row.append(lamp);
    });
    box.append(row);
  }
  return box;
}

function facts(reading: RobotReading): HTMLElement {
  const box = element('section', 'facts');
  for (const { name, value } of [...reading.analog, ...reading.facts]) {
    box.append(element('span', 'name', TITLES[name] ?? name), element('span', 'value', value));
  }
  return box;
}

function history(current: Stop): HTMLElement {
  const box = element('section', 'stops');
  box.append(element('h3', '', 'Stops'));
  for (const stop of [...shown.stops].reverse()) {
    const row = element('button', stop === current ? 'stop current' : 'stop');
    const place = stop.line > 0 ? `${stop.line} ${stop.function}` : stop.function;
    row.append(element('span', 'time', stop.reading.time), element('span', 'place', place), element('span', 'reason', stop.reason));
    row.title = `${stop.function}, line ${stop.line}: shows the robot as it was then, and the line`;
    row.onclick = () => {
      selected = stop.number;
      build();
      vscode.postMessage({ kind: 'open', stop: stop.number });
    };
    box.append(row);
  }
  return box;
}

function handle(on: HTMLCanvasElement): void {
  on.onpointerdown = (event) => on.setPointerCapture(event.pointerId);
  on.onpointermove = (event) => {
    if (event.buttons !== 0) {
      scene?.turn(0.01 * event.movementX, 0.01 * event.movementY);
      paint();
    }
  };
  on.addEventListener('wheel', (event) => {
    event.preventDefault();
    scene?.zoom(Math.exp(0.001 * event.deltaY));
    paint();
  }, { passive: false });
  on.onkeydown = (event) => {
    const turns: { readonly [key: string]: readonly [number, number] } = {
      ArrowLeft: [-0.1, 0],
      ArrowRight: [0.1, 0],
      ArrowUp: [0, 0.1],
      ArrowDown: [0, -0.1],
    };
    const turn = turns[event.key];
    if (turn !== undefined) {
      scene?.turn(...turn);
    } else if (event.key === '+' || event.key === '-') {
      scene?.zoom(event.key === '+' ? 0.9 : 1.1);
    } else {
      return;
    }
    event.preventDefault();
    paint();
  };
}

function paint(): void {
  const stop = shown.stops.find((each) => each.number === selected) ?? shown.stops[shown.stops.length - 1];
  if (stop === undefined || canvas === undefined || scene === undefined) {
    return;
  }
  const colour = getComputedStyle(canvas).color.match(/[\d.]+/g)?.map(Number) ?? [];
  const foreground: Vector = [(colour[0] ?? 128) / 255, (colour[1] ?? 128) / 255, (colour[2] ?? 128) / 255];
  const { joints: positions, tcp } = stop.reading;
  scene.draw({ joints: positions, tcp, trail }, foreground);
}

function group(className: string, ...parts: HTMLElement[]): HTMLElement {
  const box = element('div', className);
  box.append(...parts);
  return box;
}

/** Without the sign of a zero. */
function fixed(number: number, digits: number): string {
  return number.toFixed(digits).replace(/^-(?=[0.]+$)/, '');
}

function element(tag: string, className: string, text = ''): HTMLElement {
  const made = document.createElement(tag);
  made.className = className;
  made.textContent = text;
  return made;
}
