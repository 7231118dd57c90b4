package org.pendant.controller.device;

import static org.pendant.controller.device.DeviceTexts.text;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.pendant.controller.device.gripper.Fingers;
import org.pendant.controller.device.plc.AdapterPort;
import org.pendant.controller.external.Connectors;
import org.pendant.controller.external.DeviceSocket;
import org.pendant.controller.external.DeviceTalk;
import org.pendant.controller.external.ExternalSocket;
import org.pendant.controller.external.RpcLink;
import org.pendant.controller.io.SignalBank;
import org.pendant.controller.io.Signals;
import org.pendant.controller.message.MessageLog;
import org.pendant.controller.wire.CellSignal;
import org.pendant.controller.wire.CellSignalNames;
import org.pendant.controller.wire.SignalGroup;
import org.pendant.controller.wire.SignalLines;
import org.pendant.controller.world.ContactWorld;
import org.pendant.models.json.Json;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;

/**
 * Devices of the cell: what programs reach at the controller's own address, and what answers its
 * outputs, in robot time. Runs with them repeat exactly. The frame loop owns them.
 */
public final class CellDevices {
  /** Devices in a cell at most. */
  public static final int MAX = 64;

  /** Connections from outside at once; a port takes fewer. */
  private static final int MAX_CALLERS = 1024;

  /** A connection from outside. */
  private record Caller(int port, long connection) {}

  private final List<CellDevice> devices = new ArrayList<>();
  private final List<DeviceSocket> sockets = new ArrayList<>();
  private final Map<Caller, DeviceTalk> callers = new HashMap<>();
  private final Signals signals;
  private final SignalLines lines;
  private final CellSignalNames names = new CellSignalNames(SignalBank.groups());
  private List<DeviceState> states = List.of();
  private final ToolPlaces tools;
  private final ContactWorld world;
  private final EncoderTicks encoders;
  private final MessageLog log;

  /**
   * The devices of a cell, and a line in the log for each.
   *
   * @param signals of their controller
   * @param around what is around them
   */
  public CellDevices(
      List<DeviceSetup> setups, Signals signals, DeviceSurroundings around, MessageLog log) {
    world = around.world();
    encoders = around.encoders();
    tools = around.tools();
    lines = around.lines();
    this.signals = signals;
    this.log = log;
    // others may be wired to their signals
    setups.stream().filter(CellDevices::hasSignals).forEach(this::add);
    setups.stream().filter(each -> !hasSignals(each)).forEach(this::add);
  }

  private static boolean hasSignals(DeviceSetup setup) {
    return !setup.signals().isEmpty();
  }

  /**
   * Adds a device.
   *
   * @throws IllegalArgumentException if there are too many, or one has its name
   */
  public void add(DeviceSetup setup) {
    if (devices.size() >= MAX) {
      throw new IllegalArgumentException(text("tooManyDevices", MAX));
    }
    if (find(setup.name()).isPresent()) {
      throw new IllegalArgumentException(text("nameTaken", Json.quoted(setup.name())));
    }
    CellDevice device =
        switch (setup) {
          case DeviceSetup.TwoFinger gripper -> new TwoFingerDevice(gripper, signals, log);
          case DeviceSetup.RpcGripper gripper -> new RpcDevice(gripper, log);
          case DeviceSetup.Driven driven -> new DrivenDevice(driven, lines, log);
          case DeviceSetup.Vacuum vacuum ->
              new VacuumDevice(vacuum, lines, vacuum.gripper().flatMap(world::cup), log);
          case DeviceSetup.Belt belt ->
              new BeltDevice(belt, world.belt(belt.object()), encoders, lines);
          case DeviceSetup.Source source ->
              new SourceDevice(source, world.pool(source.object(), source.count()), lines, log);
          case DeviceSetup.Rail rail ->
              new RailDevice(rail, world.rail(rail.object(), rail.line()), lines);
          case DeviceSetup.Door door -> new DoorDevice(door, drive(door), lines);
          case DeviceSetup.Sink sink -> new SinkDevice(sink, world);
          case DeviceSetup.Camera camera -> new CameraDevice(camera, world, log);
          case DeviceSetup.Modbus modbus -> new PlcDevice(modbus);
          case DeviceSetup.EthernetIp scanner -> new ScannerDevice(scanner, log);
          case DeviceSetup.Lamp lamp -> new LampDevice(lamp, lines);
          case DeviceSetup.Switch pressed ->
              new SwitchDevice(pressed, new ZoneWatch(pressed.area(), tools, world), lines);
          case DeviceSetup.Sensor sensor ->
              new SensorDevice(sensor, new ZoneWatch(sensor.zone(), tools, world), lines);
        };
    setup
        .gripper()
        .flatMap(gripper -> world.fingers(gripper, setup.strokeM()))
        .ifPresent(gripper -> device.fingers().orElseThrow().among(new BodiesBetween(gripper)));
    devices.add(device);
    if (hasSignals(setup)) {
      names.add(setup.name(), setup.signals());
    }
    device.signals().ifPresent(each -> lines.add(device.name(), each));
    log.info(device.name() + ": " + device.described());
  }

  private Optional<DoorDrive> drive(DeviceSetup.Door door) {
    return door.leaf()
        .flatMap(
            leaf ->
                switch (leaf) {
                  case DoorLeaf.Slide slide -> world.rail(slide.object(), slide.line());
                  case DoorLeaf.Turn turn -> world.hinge(turn.object(), turn.axis());
                })
        .map(guide -> new DoorDrive(guide, door.leaf().orElseThrow(), door.timeS()));
  }

  /** Has scanners of the cell reach the adapter of the controller. */
  public void reach(AdapterPort adapter) {
    for (CellDevice each : devices) {
      if (each instanceof ScannerDevice scanner) {
        scanner.reach(adapter);
      }
    }
  }

  /** The ways out with the devices before them: what is no device is reached as ever. */
  public Connectors before(Connectors others) {
    return new Connectors(
        (host, port) -> open(host, port, others),
        url -> openServer(url, others),
        new CellModbus(devices, others.modbus()),
        others.toolSerial());
  }

  private ExternalSocket open(String host, int port, Connectors others) throws ScriptError {
    Optional<CellDevice> device =
        devices.stream().filter(each -> each.isAt(host, port)).findFirst();
    if (device.isPresent()) {
      DeviceSocket socket = new DeviceSocket(device.get().connect());
      sockets.add(socket);
      return socket;
    }
    return others.sockets().open(host, port);
  }

  private RpcLink openServer(String url, Connectors others) throws ScriptError {
    int port = OwnAddress.portOf(url);
    List<CellDevice> servers = servers(port);
    return servers.isEmpty() ? others.rpc().open(url) : new DeviceProcedures(servers);
  }

  private List<CellDevice> servers(int port) {
    return devices.stream().filter(each -> each.procedurePort().orElse(-1) == port).toList();
  }

  /**
   * Calls a procedure of the devices that serve a port.
   *
   * @throws IllegalArgumentException if there is none of this name, or it is called wrongly
   */
  public Value call(int port, String method, List<Value> arguments) {
    try {
      return DeviceProcedures.call(servers(port), method, arguments);
    } catch (ScriptError e) {
      throw new IllegalArgumentException(e.getMessage(), e);
    }
  }

  /**
   * Puts a part where a gripper can hold it.
   *
   * @param widthM 0 for none
   * @throws IllegalArgumentException if there is no such gripper, or the part cannot be there
   */
  public void putPart(String gripper, double widthM) {
    Optional<CellDevice> device = find(gripper);
    double maxPartWidthM = device.map(CellDevice::maxPartWidthM).orElse(1.0);
    if (!(widthM >= 0 && widthM <= maxPartWidthM)) {
      throw new IllegalArgumentException(text("partWidth", widthM, maxPartWidthM));
    }
    if (device.isEmpty() || !device.get().putPart(widthM)) {
      throw new IllegalArgumentException(none(gripper, "noGripper", "unknownGripper"));
    }
  }

  /**
   * Presses a switch by hand, or lets go of it.
   *
   * @throws IllegalArgumentException if there is no such switch
   */
  public void press(String name, boolean pressed) {
    CellDevice device = find(name).orElse(null);
    if (!(device instanceof SwitchDevice)) {
      throw new IllegalArgumentException(none(name, "noSwitch", "unknownSwitch"));
    }
    var _ = device.putPart(pressed ? 1 : 0);
  }

  /**
   * Sets a signal of the cell.
   *
   * @param name such as {@code plc.register[3]}
   * @throws IllegalArgumentException if there is none, or it cannot be set to that
   */
  public void set(String name, int value) {
    CellSignal signal = signal(name);
    SignalGroup group = names.group(signal);
    if (!group.settable()) {
      throw new IllegalArgumentException(text("signalNotSettable", signal));
    }
    group.range().require(signal.toString(), value);
    lines.line(signal).set(value);
  }

  /**
   * The value of a signal of the cell; 0 or 1 for digital ones.
   *
   * @throws IllegalArgumentException if there is none
   */
  public int value(String name) {
    return lines.line(signal(name)).value();
  }

  private CellSignal signal(String name) {
    try {
      return names.signal(name);
    } catch (IllegalArgumentException e) {
      throw new IllegalArgumentException(
          text("signalRefused", Json.quoted(name), e.getMessage()), e);
    }
  }

  /** Signals of the cell at work, those of devices included. */
  public SignalLines lines() {
    return lines;
  }

  /** Says that no device of a kind is called so: in one text where there is no device at all. */
  private String none(String name, String withoutDevices, String withDevices) {
    return devices.isEmpty()
        ? text(withoutDevices, Json.quoted(name))
        : text(
            withDevices,
            Json.quoted(name),
            devices.stream().map(CellDevice::name).collect(Collectors.joining(", ")));
  }

  private Optional<CellDevice> find(String name) {
    return devices.stream().filter(each -> each.name().equals(name)).findFirst();
  }

  /** The fingers of a gripper; empty where there are none. */
  public Optional<Fingers> fingers(String name) {
    return find(name).flatMap(CellDevice::fingers);
  }

  /**
   * Has a device hear what comes by a connection from outside, and says what it answers.
   *
   * @throws IllegalArgumentException if there is no device at this port, or too many talk to it
   */
  public String hear(int port, long connection, String bytes) {
    Caller caller = new Caller(port, connection);
    DeviceTalk talk = callers.get(caller);
    if (talk == null) {
      if (callers.size() >= MAX_CALLERS) {
        throw new IllegalArgumentException(text("tooManyCallers", MAX_CALLERS));
      }
      talk = at(port).orElseThrow(() -> noDevice(port)).connect();
      callers.put(caller, talk);
    }
    return talk.hear(bytes);
  }

  /** A connection from outside has ended. */
  public void leave(int port, long connection) {
    callers.remove(new Caller(port, connection));
  }

  private static IllegalArgumentException noDevice(int port) {
    return new IllegalArgumentException(text("portOfNoDevice", port));
  }

  private Optional<CellDevice> at(int port) {
    for (CellDevice device : devices) {
      if (device.port().orElse(0) == port) {
        return Optional.of(device);
      }
    }
    return Optional.empty();
  }

  /** Whether programs reach a device at a port of this controller. */
  public boolean listensAt(int port) {
    return at(port).isPresent();
  }

  /** What all devices are at; the same list as before while nothing changes. */
  public List<DeviceState> states() {
    boolean same = states.size() == devices.size();
    for (int i = 0; same && i < devices.size(); i++) {
      same = isAt(devices.get(i), states.get(i));
    }
    if (!same) {
      states = List.copyOf(devices.stream().map(CellDevices::state).toList());
    }
    return states;
  }

  private static boolean isAt(CellDevice device, DeviceState state) {
    return device.on() == state.on()
        && device.signalStates().equals(state.signals())
        && device.partWidthM() == state.partWidthM()
        && device.openingM() == state.openingM()
        && device.pressN() == state.forceN();
  }

  private static DeviceState state(CellDevice device) {
    return new DeviceState(
        device.name(),
        device.kind(),
        device.strokeM(),
        device.openingM(),
        device.pressN(),
        device.on(),
        device.maxPartWidthM(),
        device.partWidthM(),
        device.port().orElse(0),
        device.procedurePort().orElse(0),
        device.signalStates());
  }

  /** Hears what programs have sent, answers, and moves everything through one frame. */
  public void step() {
    tools.beginFrame();
    for (int i = sockets.size() - 1; i >= 0; i--) {
      if (!sockets.get(i).step()) {
        sockets.remove(i);
      }
    }
    for (int i = 0; i < devices.size(); i++) {
      devices.get(i).step();
    }
  }
}
