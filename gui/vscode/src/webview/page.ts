/** The page of the robot panel. */
import { arms } from 'pendant:arms';
import { share, type LogLine, type Timeline } from '../panel/live';
import type { Show, State, Step, Wish } from '../panel/messages';
import type { RobotReading } from '../panel/reading';
import type { Stop } from '../panel/stops';
import { Scene } from './scene';
import type { Vector } from './matrix';

declare function acquireVsCodeApi(): { postMessage(wish: Wish): void };

const JOINTS = ['Base', 'Shoulder', 'Elbow', 'Wrist 1', 'Wrist 2', 'Wrist 3'];
const POSE = ['X', 'Y', 'Z', 'RX', 'RY', 'RZ'];
const STATES: { readonly [state in State]: string } = {
  none: 'nothing runs',
  running: 'live',
  stopped: 'stopped',
  past: 'in the past',
  ended: 'ended',
};
const STEPS: readonly { readonly step: Step; readonly text: string; readonly title: string }[] = [
  { step: 'moveBack', text: '\u00ab', title: 'Back to where the last move began' },
  { step: 'back', text: '\u2039', title: 'Back to the last statement' },
  { step: 'on', text: '\u203a', title: 'On to the next statement' },
  { step: 'moveOn', text: '\u00bb', title: 'On to where a move begins or ends' },
];
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
/** Nearer than this two points of the trail are one. */
const TRAIL_M = 0.002;
const MOST_TRAIL = 5000;

const vscode = acquireVsCodeApi();
const main = document.querySelector('main') ?? document.body;
let shown: Show = { kind: 'show', state: 'none', stops: [], now: undefined, timeline: undefined, log: [] };
/** The earlier stop that is looked at; undefined for what there is now. */
let selected: number | undefined;
let trail: readonly Vector[] = [];
let canvas: HTMLCanvasElement | undefined;
let scene: Scene | undefined;
let sceneArm = '';
let parts: Parts | undefined;

/** What stays while its content changes, so that it can be held with the mouse. */
interface Parts {
  readonly robot: HTMLElement;
  readonly status: HTMLElement;
  readonly description: HTMLElement;
  readonly time: TimeBar;
  readonly positions: HTMLElement;
  readonly signals: HTMLElement;
  readonly facts: HTMLElement;
  readonly stops: HTMLElement;
  readonly log: HTMLElement;
}

interface TimeBar {
  readonly box: HTMLElement;
  readonly slider: HTMLInputElement;
  readonly ticks: HTMLElement;
  readonly text: HTMLElement;
  readonly buttons: readonly HTMLButtonElement[];
  readonly now: HTMLButtonElement;
}

window.addEventListener('message', (event: MessageEvent<Show>) => {
  const before = shown;
  shown = event.data;
  if (shown.stops.length !== before.stops.length || shown.state === 'running') {
    selected = undefined;
  }
  leaveTrail();
  build(before);
});
window.addEventListener('resize', paint);
new MutationObserver(paint).observe(document.body, { attributes: true, attributeFilter: ['class'] });
build(shown);
vscode.postMessage({ kind: 'ready' });

/** Where the tool has been since the program began. */
function leaveTrail(): void {
  const tcp = shown.now?.tcp;
  if (shown.now === undefined) {
    trail = [];
  } else if (tcp?.length === 6 && shown.state !== 'past') {
    const [x = 0, y = 0, z = 0] = tcp;
    const last = trail[trail.length - 1];
    if (last === undefined || Math.hypot(x - last[0], y - last[1], z - last[2]) > TRAIL_M) {
      trail = [...trail, [x, y, z] as Vector].slice(-MOST_TRAIL);
    }
  }
}

function selectedStop(): Stop | undefined {
  return shown.stops.find((each) => each.number === selected);
}

function reading(): RobotReading | undefined {
  return selectedStop()?.reading ?? shown.now;
}

function build(before: Show): void {
  const now = reading();
  if (now === undefined) {
    canvas = undefined;
    scene = undefined;
    parts = undefined;
    main.replaceChildren(
      element('p', 'hint', shown.state === 'running'
        ? 'The program begins.'
        : 'Debug a program: its robot is shown here, while it runs and where it stops.'),
    );
    return;
  }
  parts ??= skeleton();
  if (parts.robot.firstChild === null || sceneArm !== now.arm) {
    parts.robot.replaceChildren(view(now));
  }
  showStatus(parts, now);
  showTime(parts.time);
  parts.positions.replaceChildren(...joints(now));
  showSignals(parts.signals, now);
  parts.facts.replaceChildren(...facts(now));
  if (before.stops !== shown.stops || parts.stops.childElementCount === 0) {
    parts.stops.replaceChildren(...history());
  }
  if (before.log.length !== shown.log.length || before.log[0]?.id !== shown.log[0]?.id || before.state !== shown.state || parts.log.childElementCount === 0) {
    showLog(parts.log);
  }
  paint();
}

function skeleton(): Parts {
  const made: Parts = {
    robot: element('div', 'robot-view'),
    status: element('div', 'status'),
    description: element('div', 'description'),
    time: timeBar(),
    positions: element('section', 'positions'),
    signals: element('section', 'signals'),
    facts: element('section', 'facts'),
    stops: element('section', 'stops'),
    log: element('section', 'log'),
  };
  main.replaceChildren(
    group('robot', made.robot, made.status, made.time.box, made.description),
    made.positions,
    group('io', made.signals, made.facts),
    group('lists', made.log, made.stops),
  );
  return made;
}

function view(now: RobotReading): HTMLElement {
  const arm = arms[now.arm.toLowerCase()] ?? arms['ur5e'];
  sceneArm = now.arm;
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
  canvas.setAttribute('aria-label', `${arm?.name ?? 'The arm'}, drag or press the arrow keys to turn it`);
  canvas.title = 'Drag or arrow keys: turn. Wheel, + and -: zoom.';
  const box = element('div', 'view');
  box.append(canvas, element('span', 'arm', arm?.name ?? now.arm));
  return box;
}

function showStatus({ status, description }: Parts, now: RobotReading): void {
  const stop = selectedStop();
  const words = stop === undefined ? STATES[shown.state] : 'earlier stop';
  status.replaceChildren(
    element('span', `badge ${stop === undefined ? shown.state : 'earlier'}`, words),
    element('span', 'time', now.time),
  );
  const last = shown.state === 'stopped' || shown.state === 'past' ? shown.stops[shown.stops.length - 1] : undefined;
  description.textContent = (stop ?? last)?.description ?? '';
}

function button(text: string, title: string, does: () => void): HTMLButtonElement {
  const made = element('button', 'small', text) as HTMLButtonElement;
  made.title = title;
  made.setAttribute('aria-label', title);
  made.onclick = does;
  return made;
}

function timeBar(): TimeBar {
  const slider = document.createElement('input');
  slider.type = 'range';
  slider.step = '0.002';
  slider.setAttribute('aria-label', 'Robot time that is looked at');
  slider.title = 'Robot time that is looked at: drag it, or press the arrow keys';
  const look = (stay: boolean) => {
    selected = undefined;
    vscode.postMessage({ kind: 'time', timeS: Number(slider.value), stay });
  };
  slider.oninput = () => look(false);
  slider.onchange = () => look(true);
  const ticks = element('div', 'ticks');
  const text = element('span', 'time');
  const buttons = STEPS.map((each) => button(each.text, each.title, () => vscode.postMessage({ kind: 'step', step: each.step })));
  const now = button('Now', 'Look at the robot as it is now', () => {
    selected = undefined;
    vscode.postMessage({ kind: 'now' });
  });
  const line = group('line', slider, ticks);
  const row = group('row', ...buttons, text, now);
  return { box: group('timebar', line, row), slider, ticks, text, buttons, now };
}

function showTime(bar: TimeBar): void {
  const timeline = shown.timeline;
  const standing = shown.state === 'stopped' || shown.state === 'past';
  bar.buttons.forEach((each) => {
    each.disabled = !standing;
  });
  bar.slider.disabled = timeline === undefined || shown.state === 'ended';
  if (timeline === undefined) {
    return;
  }
  bar.slider.min = String(timeline.fromS);
  bar.slider.max = String(timeline.nowS);
  if (!bar.slider.matches(':active')) {
    bar.slider.value = String(timeline.atS);
  }
  const back = timeline.nowS - timeline.atS;
  bar.now.disabled = shown.state !== 'past' && (shown.state !== 'running' || back < 0.5);
  bar.text.textContent = `of ${fixed(timeline.nowS, 3)} s`;
  bar.ticks.replaceChildren(
    ...shown.log.map((each) => tick('tick', timeline, each.timeS, each.text)),
    ...shown.stops.map((each) => tick('tick stopped', timeline, each.timeS, `${each.reason}, line ${each.line}`)),
  );
}

function tick(className: string, timeline: Timeline, timeS: number, title: string): HTMLElement {
  const made = element('span', className);
  made.style.setProperty('--share', String(share(timeline, timeS)));
  made.title = title;
  return made;
}

function joints({ joints: positions, tcp }: RobotReading): HTMLElement[] {
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
  return [table, pose];
}

/** Whether signals can be switched: the robot is looked at as it is now. */
function switchable(): boolean {
  const timeline = shown.timeline;
  const atNow = timeline === undefined || timeline.nowS - timeline.atS < 0.5;
  return selected === undefined && (shown.state === 'stopped' || (shown.state === 'running' && atNow));
}

function showSignals(box: HTMLElement, now: RobotReading): void {
  const form = now.banks.map((each) => `${each.name} ${each.on.length}`).join();
  if (box.dataset['form'] !== form) {
    box.dataset['form'] = form;
    box.replaceChildren(...now.banks.map((each) => bank(each.name, each.on.length)));
  }
  const able = switchable();
  const lamps = [...box.querySelectorAll<HTMLButtonElement>('.lamp')];
  now.banks
    .flatMap((each) => each.on.map((on, index) => ({ name: each.name, index, on })))
    .forEach(({ name, index, on }, i) => {
      const lamp = lamps[i];
      if (lamp !== undefined) {
        lamp.className = on ? 'lamp on' : 'lamp';
        lamp.disabled = !able;
        lamp.setAttribute('aria-pressed', String(on));
        lamp.title = `${name}[${index}] is ${on ? 'on' : 'off'}${able ? `: switch it ${on ? 'off' : 'on'}` : ''}`;
      }
    });
}

function bank(name: string, count: number): HTMLElement {
  const row = element('div', 'bank');
  row.append(element('span', 'name', TITLES[name] ?? name));
  for (let index = 0; index < count; index++) {
    const lamp = element('button', 'lamp', String(index)) as HTMLButtonElement;
    lamp.onclick = () =>
      vscode.postMessage({ kind: 'signal', bank: name, index, on: lamp.getAttribute('aria-pressed') !== 'true' });
    row.append(lamp);
  }
  return row;
}

function facts(now: RobotReading): HTMLElement[] {
  return [...now.analog, ...now.facts].flatMap(({ name, value }) => [
    element('span', 'name', TITLES[name] ?? name),
    element('span', 'value', value),
  ]);
}

function history(): HTMLElement[] {
  const current = selectedStop() ?? shown.stops[shown.stops.length - 1];
  const rows = [...shown.stops].reverse().map((stop) => {
    const row = element('button', stop === current ? 'stop current' : 'stop');
    const place = stop.line > 0 ? `${stop.line} ${stop.function}` : stop.function;
    row.append(element('span', 'time', stop.reading.time), element('span', 'place', place), element('span', 'reason', stop.reason));
    row.title = `${stop.function}, line ${stop.line}: shows the robot as it was then, and the line`;
    row.onclick = () => {
      selected = stop.number;
      parts?.stops.replaceChildren();
      build(shown);
      vscode.postMessage({ kind: 'open', stop: stop.number });
    };
    return row;
  });
  return [element('h3', '', 'Stops'), ...rows];
}

function showLog(box: HTMLElement): void {
  const standing = shown.state === 'stopped' || shown.state === 'past';
  box.replaceChildren(element('h3', '', 'Output'), ...[...shown.log].reverse().map((each) => logRow(each, standing)));
}

function logRow(line: LogLine, standing: boolean): HTMLElement {
  const row = element('button', 'stop') as HTMLButtonElement;
  row.append(
    element('span', 'time', `${fixed(line.timeS, 3)} s`),
    element('span', 'place', line.text),
    element('span', 'reason', line.line === undefined ? '' : `line ${line.line}`),
  );
  row.disabled = !standing;
  row.title = standing ? `${line.text}: go to the moment this was written` : `${line.text}: pause the program to go to the moment this was written`;
  row.onclick = () => vscode.postMessage({ kind: 'moment', id: line.id });
  return row;
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
  const now = reading();
  if (now === undefined || canvas === undefined || scene === undefined) {
    return;
  }
  const colour = getComputedStyle(canvas).color.match(/[\d.]+/g)?.map(Number) ?? [];
  const foreground: Vector = [(colour[0] ?? 128) / 255, (colour[1] ?? 128) / 255, (colour[2] ?? 128) / 255];
  scene.draw({ joints: now.joints, tcp: now.tcp, trail }, foreground);
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
