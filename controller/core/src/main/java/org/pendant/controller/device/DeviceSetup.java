package org.pendant.controller.device;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import org.pendant.cell.BodyRail;
import org.pendant.controller.device.camera.PartCamera;
import org.pendant.controller.device.plc.AdapterScanner;
import org.pendant.controller.device.plc.ModbusMemory;
import org.pendant.controller.device.plc.ModbusTable;
import org.pendant.controller.device.plc.ModbusUnit;
import org.pendant.controller.external.ModbusAddress;
import org.pendant.controller.wire.CellSignal;
import org.pendant.controller.wire.SignalGroup;
import org.pendant.controller.world.GripperSetup;
import org.pendant.models.pose.Pose;

/** Setup of a device: what it is and how it begins. */
public sealed interface DeviceSetup {
  /** The kinds of devices that need nothing but their name. */
  List<String> KINDS =
      DeviceKind.ALL.stream().filter(DeviceKind::plain).map(DeviceKind::type).toList();

  /** The name that messages, rules and tests call it by. */
  String name();

  /** Whether it can hold a part. */
  default boolean holdsParts() {
    return true;
  }

  /** What it touches bodies with; empty where it grips none. */
  default Optional<GripperSetup> gripper() {
    return Optional.empty();
  }

  /** The signals that others may be wired to, by the name of this device. */
  default List<SignalGroup> signals() {
    return List.of();
  }

  /** Whether it can be pressed. */
  default boolean canBePressed() {
    return false;
  }

  /** How wide a part may be that it holds, m. */
  double strokeM();

  /**
   * A device of a kind as it is delivered, called by the kind.
   *
   * @param kind one of {@link #KINDS}
   */
  static Optional<DeviceSetup> of(String kind) {
    return switch (kind) {
      case "two-finger" -> Optional.of(new TwoFinger(kind, false, true, 0));
      case "two-finger-tool" -> Optional.of(new TwoFinger(kind, true, false, 0));
      case "rg", "2fg" -> Optional.of(new RpcGripper(kind, kind, 0));
      case "ethernetip" -> Optional.of(new EthernetIp(kind, EthernetIp.INTERVAL_S, Map.of()));
      default -> Optional.empty();
    };
  }

  /**
   * Adaptive two-finger gripper with an 85 mm stroke.
   *
   * @param atTool whether it is on the serial line of the tool; at the socket of its driver
   *     otherwise
   * @param activated whether it was activated before programs begin
   * @param partWidthM width of a part between its fingers, 0 for none
   * @param gripper its fingertips
   */
  record TwoFinger(
      String name,
      boolean atTool,
      boolean activated,
      double partWidthM,
      Optional<GripperSetup> gripper)
      implements DeviceSetup {
    static final double STROKE_M = 0.085;

    /** One whose fingertips are at the tool centre point. */
    public TwoFinger(String name, boolean atTool, boolean activated, double partWidthM) {
      this(name, atTool, activated, partWidthM, Optional.of(GripperSetup.FINGERS));
    }

    @Override
    public double strokeM() {
      return STROKE_M;
    }
  }

  /**
   * Gripper that is worked by remote procedures.
   *
   * @param kind rg or 2fg
   * @param partWidthM width of a part between its fingers, 0 for none
   * @param gripper its fingertips
   */
  record RpcGripper(String name, String kind, double partWidthM, Optional<GripperSetup> gripper)
      implements DeviceSetup {
    static final double RG_STROKE_M = 0.110;
    static final double TWO_FG_STROKE_M = 0.039;

    /** One whose fingertips are at the tool centre point. */
    public RpcGripper(String name, String kind, double partWidthM) {
      this(name, kind, partWidthM, Optional.of(GripperSetup.FINGERS));
    }

    @Override
    public double strokeM() {
      return kind.equals("rg") ? RG_STROKE_M : TWO_FG_STROKE_M;
    }
  }

  /**
   * Gripper with two fingers that two outputs, or one, drive from end to end.
   *
   * @param close the output that closes it
   * @param open the output that opens it; without one it opens while {@code close} is low
   * @param closed the input that tells that it is closed, where there is one
   * @param opened the input that tells that it is open, where there is one
   * @param gripped the input that tells that it holds something, where there is one
   * @param strokeM how far it opens
   * @param timeS how long it takes from end to end
   * @param partWidthM width of a part in it, 0 for none
   * @param gripper its fingertips
   */
  record Driven(
      String name,
      CellSignal close,
      Optional<CellSignal> open,
      Optional<CellSignal> closed,
      Optional<CellSignal> opened,
      Optional<CellSignal> gripped,
      double strokeM,
      double timeS,
      double partWidthM,
      Optional<GripperSetup> gripper)
      implements DeviceSetup {}

  /**
   * Door that two outputs, or one, drive from end to end.
   *
   * @param close the output that closes it
   * @param open the output that opens it; without one it opens while {@code close} is low
   * @param closed the input that tells that it is closed, where there is one
   * @param opened the input that tells that it is open, where there is one
   * @param timeS how long it takes from end to end
   * @param leaf what it moves, where that is an object of the scene
   */
  record Door(
      String name,
      CellSignal close,
      Optional<CellSignal> open,
      Optional<CellSignal> closed,
      Optional<CellSignal> opened,
      double timeS,
      Optional<DoorLeaf> leaf)
      implements DeviceSetup {
    @Override
    public boolean holdsParts() {
      return false;
    }

    @Override
    public double strokeM() {
      return 0;
    }
  }

  /**
   * Vacuum gripper.
   *
   * @param suck the output that sucks
   * @param holds the input that tells that it holds something, where there is one
   * @param timeS how long the vacuum takes to build up and to go
   * @param part whether there is a part to hold
   * @param gripper its cup
   */
  record Vacuum(
      String name,
      CellSignal suck,
      Optional<CellSignal> holds,
      double timeS,
      boolean part,
      Optional<GripperSetup> gripper)
      implements DeviceSetup {
    @Override
    public double strokeM() {
      return 1;
    }
  }

  /**
   * Belt: a box of the scene whose surface runs along its x.
   *
   * @param object name of the box
   * @param speedMPerS while it runs
   * @param accelerationMPerS2 with which it starts and stops
   * @param run the output that has it run; without one it always does
   * @param encoder which one it turns, 0 or 1; -1 for none
   * @param ticksPerM of this encoder
   */
  record Belt(
      String name,
      String object,
      double speedMPerS,
      double accelerationMPerS2,
      Optional<CellSignal> run,
      int encoder,
      double ticksPerM)
      implements DeviceSetup {
    @Override
    public boolean holdsParts() {
      return false;
    }

    @Override
    public double strokeM() {
      return 0;
    }
  }

  /**
   * Source of parts, which puts copies of an object where that was at first.
   *
   * @param object name of the object
   * @param everyS time between two; 0 where only {@code when} has one come
   * @param when the signal whose rise has one come, where there is one
   * @param count how many there are at most, the object itself among them
   */
  record Source(String name, String object, double everyS, Optional<CellSignal> when, int count)
      implements DeviceSetup {
    @Override
    public boolean holdsParts() {
      return false;
    }

    @Override
    public double strokeM() {
      return 0;
    }
  }

  /**
   * Rail: guides an object along a line, from where it is at first.
   *
   * @param object its name
   * @param line in the frame of the cell
   * @param closed the input that tells that the object is where it was at first, where there is one
   * @param opened the input that tells that it is at the other end, where there is one
   */
  record Rail(
      String name,
      String object,
      BodyRail.Line line,
      Optional<CellSignal> closed,
      Optional<CellSignal> opened)
      implements DeviceSetup {
    /** How far the object goes. */
    double travelM() {
      return line.travelM();
    }

    @Override
    public boolean holdsParts() {
      return false;
    }

    @Override
    public double strokeM() {
      return 0;
    }
  }

  /**
   * Sink of parts, which takes away what has its middle in an area.
   *
   * @param area where
   */
  record Sink(String name, Zone.Area area) implements DeviceSetup {
    @Override
    public boolean holdsParts() {
      return false;
    }

    @Override
    public double strokeM() {
      return 0;
    }
  }

  /**
   * Camera that tells where parts are.
   *
   * @param area where it sees the objects that have their middle there
   * @param objects names of those that it knows, with their copies; empty for all
   * @param atInBase where it is, if it tells poses in its own frame; in the base frame otherwise
   * @param occlusion whether it does not see what others hide from there
   */
  record Camera(
      String name,
      Zone.Area area,
      List<String> objects,
      Optional<Pose> atInBase,
      boolean occlusion,
      Ports ports,
      PartCamera.Errors errors)
      implements DeviceSetup {
    /**
     * Where programs reach it.
     *
     * @param lines port of the socket
     * @param procedures port of its remote procedures
     */
    public record Ports(int lines, int procedures) {}

    /** Copies the list. */
    public Camera {
      objects = List.copyOf(objects);
    }

    @Override
    public boolean holdsParts() {
      return false;
    }

    @Override
    public double strokeM() {
      return 0;
    }
  }

  /**
   * Device that is reached by Modbus TCP.
   *
   * @param address by which programs reach it, without a connection to the outside
   * @param unit the number that it answers to; empty for all
   * @param port of this controller at which other computers reach it; empty for none
   * @param first address of the first coil, input, register and input register
   * @param counts how many there are of each
   * @param values what is not 0 at first
   */
  record Modbus(
      String name,
      ModbusAddress address,
      OptionalInt unit,
      OptionalInt port,
      int first,
      Map<ModbusTable, Integer> counts,
      Map<CellSignal, Integer> values)
      implements DeviceSetup {
    /** Copies the maps. */
    public Modbus {
      counts = Map.copyOf(counts);
      values = Map.copyOf(values);
    }

    @Override
    public List<SignalGroup> signals() {
      List<SignalGroup> groups = new ArrayList<>(ModbusMemory.groups(first, counts));
      groups.add(ModbusUnit.ONLINE);
      return groups;
    }

    @Override
    public boolean holdsParts() {
      return false;
    }

    @Override
    public double strokeM() {
      return 0;
    }
  }

  /**
   * PLC that is a scanner of the controller's EtherNet/IP adapter.
   *
   * @param intervalS between two packets, each way
   * @param values what it writes at first that is not 0
   */
  record EthernetIp(String name, double intervalS, Map<CellSignal, Integer> values)
      implements DeviceSetup {
    /** The interval of one that says nothing of it. */
    static final double INTERVAL_S = 0.01;

    /** Copies the map. */
    public EthernetIp {
      values = Map.copyOf(values);
    }

    @Override
    public List<SignalGroup> signals() {
      return AdapterScanner.GROUPS;
    }

    @Override
    public boolean holdsParts() {
      return false;
    }

    @Override
    public double strokeM() {
      return 0;
    }
  }

  /**
   * Switch that is pressed by what touches it, and by hand.
   *
   * @param kind limit-switch or button
   * @param signal the input that tells
   * @param area where something presses it
   * @param inverted whether the input is high while nothing does
   */
  record Switch(String name, String kind, CellSignal signal, Zone.Area area, boolean inverted)
      implements DeviceSetup {
    @Override
    public boolean holdsParts() {
      return false;
    }

    @Override
    public boolean canBePressed() {
      return true;
    }

    @Override
    public double strokeM() {
      return 0;
    }
  }

  /**
   * Lamp.
   *
   * @param signal that it shows
   * @param atInBase where it is to be seen, if it is
   */
  record Lamp(String name, CellSignal signal, Optional<Pose> atInBase) implements DeviceSetup {
    @Override
    public boolean holdsParts() {
      return false;
    }

    @Override
    public double strokeM() {
      return 0;
    }
  }

  /**
   * Sensor that sees the tool centre point and bodies.
   *
   * @param signal the input that tells
   * @param zone where it sees something
   * @param inverted whether the input is high while it sees nothing
   */
  record Sensor(String name, CellSignal signal, Zone zone, boolean inverted)
      implements DeviceSetup {
    @Override
    public boolean holdsParts() {
      return false;
    }

    @Override
    public double strokeM() {
      return 0;
    }
  }
}
