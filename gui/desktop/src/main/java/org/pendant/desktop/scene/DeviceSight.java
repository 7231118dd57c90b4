package org.pendant.desktop.scene;

import static org.pendant.desktop.scene.SceneTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Stream;
import org.pendant.controller.device.DeviceSetup;
import org.pendant.controller.device.DeviceState;
import org.pendant.controller.device.Zone;
import org.pendant.controller.world.GripperSetup;
import org.pendant.controller.world.Vector3;
import org.pendant.kit.text.Messages;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;

/**
 * Device sight: what is to be seen of the devices of the cell; immutable.
 *
 * @param grippers on the flange
 * @param sensors where they see something, and where parts are taken away
 * @param doors which have no place: they are told beside the picture
 * @param belts which carry what lies on them
 * @param lamps that have a place
 * @param views of cameras that are chosen
 * @param cellInBase the frame of the places of sensors, in that of the picture
 */
public record DeviceSight(
    List<Gripper> grippers,
    List<Sensor> sensors,
    List<Door> doors,
    List<Belt> belts,
    List<Lamp> lamps,
    List<CameraView> views,
    Pose cellInBase) {
  /** None. */
  public static final DeviceSight NONE =
      new DeviceSight(List.of(), List.of(), List.of(), List.of(), List.of(), List.of(), Pose.ZERO);

  /** Copies the lists. */
  public DeviceSight {
    grippers = List.copyOf(grippers);
    sensors = List.copyOf(sensors);
    doors = List.copyOf(doors);
    belts = List.copyOf(belts);
    lamps = List.copyOf(lamps);
    views = List.copyOf(views);
  }

  /**
   * A gripper.
   *
   * @param gripper what it touches with; its middle is the tool centre point where nothing else is
   *     said
   * @param strokeM how far its fingers open
   * @param openingM how far they are open; empty where that is not known
   * @param holds whether it holds something
   * @param partWidthM how wide a part is that was put there and is no object of the scene; 0 for
   *     none
   */
  public record Gripper(
      GripperSetup gripper,
      double strokeM,
      OptionalDouble openingM,
      boolean holds,
      double partWidthM) {
    /** Where its middle is, in the flange. */
    public Pose inFlange(Pose tcpInFlange) {
      return gripper.atInFlange().orElse(tcpInFlange);
    }
  }

  /** A sensor, and whether it sees something. */
  public record Sensor(String name, Zone zone, boolean sees) {}

  /**
   * A belt.
   *
   * @param object the box whose surface runs
   * @param backwards whether it runs against the box's x axis
   * @param travelM how far it has gone
   */
  public record Belt(String name, String object, boolean backwards, double travelM) {}

  /**
   * A lamp.
   *
   * @param inBase where it is
   */
  public record Lamp(String name, Pose inBase, boolean lit) {
    /** How large it is drawn, m. */
    public static final double RADIUS_M = 0.025;
  }

  /**
   * What a camera sees from where it is.
   *
   * @param eyeInCell where it is, m
   * @param area what it sees
   */
  public record CameraView(Vector3 eyeInCell, Zone.Area area) {}

  /** The same with the view of the camera of a name, where that is one and has a place. */
  public DeviceSight choosing(String name, List<DeviceSetup> setups) {
    List<CameraView> chosen = new ArrayList<>();
    for (DeviceSetup setup : setups) {
      if (setup instanceof DeviceSetup.Camera camera && camera.name().equals(name)) {
        camera
            .atInBase()
            .map(at -> new CameraView(new Vector3(at.x(), at.y(), at.z()), camera.area()))
            .ifPresent(chosen::add);
      }
    }
    return new DeviceSight(grippers, sensors, doors, belts, lamps, chosen, cellInBase);
  }

  /** The same with belts that have gone so far, by their names, m. */
  public DeviceSight withTravel(Map<String, Double> travelM) {
    return new DeviceSight(
        grippers,
        sensors,
        doors,
        belts.stream()
            .map(
                each ->
                    new Belt(
                        each.name(),
                        each.object(),
                        each.backwards(),
                        travelM.getOrDefault(each.name(), 0.0)))
            .toList(),
        lamps,
        views,
        cellInBase);
  }

  /** The same with what is to be seen of the devices of another controller, its grippers apart. */
  public DeviceSight and(DeviceSight other) {
    return new DeviceSight(
        grippers,
        joined(sensors, other.sensors),
        joined(doors, other.doors),
        joined(belts, other.belts),
        joined(lamps, other.lamps),
        joined(views, other.views),
        cellInBase);
  }

  private static <T> List<T> joined(List<T> first, List<T> second) {
    return Stream.concat(first.stream(), second.stream()).toList();
  }

  /**
   * The same for a picture in the frame of a base that stands somewhere in the cell.
   *
   * @param cell the frame of the cell in that of the base
   */
  public DeviceSight seenFrom(Pose cell) {
    return cell.equals(Pose.ZERO)
        ? this
        : new DeviceSight(
            grippers,
            sensors,
            doors,
            belts,
            lamps.stream()
                .map(each -> new Lamp(each.name(), Poses.trans(cell, each.inBase()), each.lit()))
                .toList(),
            views,
            cell);
  }

  /** A place of the cell in the frame of the picture, m. */
  Vector3 placed(Vector3 inCellM) {
    if (cellInBase.equals(Pose.ZERO)) {
      return inCellM;
    }
    Pose at = Poses.trans(cellInBase, new Pose(inCellM.x(), inCellM.y(), inCellM.z(), 0, 0, 0));
    return new Vector3(at.x(), at.y(), at.z());
  }

  /**
   * A door.
   *
   * @param openShare how far it is open, 0 to 1; empty where that is not known
   */
  public record Door(String name, OptionalDouble openShare) {
    /** Such as {@code door: closed}. */
    public String words() {
      if (openShare.isEmpty()) {
        return name;
      }
      double share = openShare.getAsDouble();
      String how =
          share <= 0
              ? text("doorClosed")
              : share >= 1
                  ? text("doorOpen")
                  : text("doorOpenPercent", String.format(Locale.ROOT, "%.0f", 100 * share));
      return Messages.told(name, how);
    }
  }

  /**
   * What is seen of devices.
   *
   * @param states what they are at; those that are missing are not known
   * @param begins whether a device whose state is missing is as it begins
   */
  public static DeviceSight of(List<DeviceSetup> setups, List<DeviceState> states, boolean begins) {
    List<Gripper> grippers = new ArrayList<>();
    List<Sensor> sensors = new ArrayList<>();
    List<Door> doors = new ArrayList<>();
    List<Belt> belts = new ArrayList<>();
    List<Lamp> lamps = new ArrayList<>();
    for (DeviceSetup setup : setups) {
      Optional<DeviceState> state =
          states.stream().filter(each -> each.name().equals(setup.name())).findFirst();
      if (setup instanceof DeviceSetup.Sensor sensor) {
        sensors.add(
            new Sensor(sensor.name(), sensor.zone(), state.map(DeviceState::on).orElse(false)));
      } else if (setup instanceof DeviceSetup.Sink sink) {
        sensors.add(new Sensor(sink.name(), sink.area(), state.map(DeviceState::on).orElse(false)));
      } else if (setup instanceof DeviceSetup.Switch pressed) {
        sensors.add(
            new Sensor(pressed.name(), pressed.area(), state.map(DeviceState::on).orElse(false)));
      } else if (setup instanceof DeviceSetup.Camera camera) {
        sensors.add(
            new Sensor(camera.name(), camera.area(), state.map(DeviceState::on).orElse(false)));
      } else if (setup instanceof DeviceSetup.Lamp lamp) {
        boolean lit = state.map(DeviceState::on).orElse(false);
        lamp.atInBase().ifPresent(at -> lamps.add(new Lamp(lamp.name(), at, lit)));
      } else if (setup instanceof DeviceSetup.Belt belt) {
        belts.add(new Belt(belt.name(), belt.object(), belt.speedMPerS() < 0, 0));
      } else if (setup.gripper().isPresent()) {
        grippers.add(gripper(setup, state, begins));
      } else if (setup instanceof DeviceSetup.Door door) {
        doors.add(new Door(door.name(), share(state, begins)));
      }
    }
    return new DeviceSight(grippers, sensors, doors, belts, lamps, List.of(), Pose.ZERO);
  }

  private static Gripper gripper(DeviceSetup setup, Optional<DeviceState> state, boolean begins) {
    OptionalDouble openingM =
        state.isPresent()
            ? OptionalDouble.of(state.get().openingM())
            : begins ? OptionalDouble.of(setup.strokeM()) : OptionalDouble.empty();
    return new Gripper(
        setup.gripper().orElseThrow(),
        setup.strokeM(),
        openingM,
        state.map(DeviceState::on).orElse(false),
        state.map(DeviceState::partWidthM).orElse(0.0));
  }

  private static OptionalDouble share(Optional<DeviceState> state, boolean begins) {
    return state.isPresent()
        ? OptionalDouble.of(state.get().openingM() / state.get().strokeM())
        : begins ? OptionalDouble.of(1) : OptionalDouble.empty();
  }
}
