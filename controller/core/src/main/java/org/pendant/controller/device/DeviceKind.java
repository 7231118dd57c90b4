package org.pendant.controller.device;

import static org.pendant.controller.device.DeviceTexts.text;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Stream;
import org.pendant.controller.world.GripperSetup;
import org.pendant.models.json.Range;
import org.pendant.models.pose.Pose;

/**
 * Device kind: what there is of devices, and what each may have in the file of a scene besides its
 * type and name. Files are read, and forms are made, by these.
 *
 * @param type as files say it
 * @param title as people say it
 * @param reached what programs reach it by, in words; empty for nothing
 */
public record DeviceKind(String type, String title, String reached, List<DeviceField> fields) {
  /** Parts that all sources have at most: each is looked at in every frame. */
  static final int MAX_PARTS = 100;

  /** Names that a camera may know. */
  private static final int MAX_NAMES = 100;

  private static final String SIGNALS = text("reachedOutputsAndInputs");
  private static final Range STROKE = new Range(0.001, 1, "m");
  private static final Range TIME = new Range(0.01, 60, "s");
  private static final Range POSITION = new Range(-10, 10, "m");
  private static final Range SPOT = new Range(-4, 4, "m");
  private static final Range ROTATION = new Range(-100, 100, "rad");
  private static final Range DISTANCE = new Range(0.001, 10, "m");

  /** Where fingers are at first that are not at the TCP, in the flange. */
  private static final Pose FIRST_HAND = new Pose(0, 0, 0.15, 0, 0, 0);

  /** Where a camera is at first that tells poses in its own frame: it looks down. */
  private static final Pose FIRST_CAMERA = new Pose(0.4, 0, 1, Math.PI, 0, 0);

  /** Where a lamp is at first that is to be seen. */
  private static final Pose FIRST_LAMP = new Pose(0.5, -0.5, 0.5, 0, 0, 0);

  private static final String COUNTED = text("countHelp");
  private static final Range COUNT = new Range(0, 1000, "");
  private static final double FIRST_COUNT = 16;
  private static final Range PORT = new Range(1024, 65_535, "");

  /** All kinds, as documentation lists them. */
  public static final List<DeviceKind> ALL =
      List.of(
          twoFinger("two-finger", text("twoFingerTitle"), text("reachedSocket"), true),
          twoFinger("two-finger-tool", text("twoFingerToolTitle"), text("reachedToolLine"), false),
          procedures("rg", text("rgTitle"), DeviceSetup.RpcGripper.RG_STROKE_M),
          procedures("2fg", text("twoFgTitle"), DeviceSetup.RpcGripper.TWO_FG_STROKE_M),
          new DeviceKind(
              "gripper",
              text("drivenTitle"),
              SIGNALS,
              List.of(
                  close(),
                  open(),
                  closed(),
                  opened(),
                  told("gripped", text("gripped"), text("holdsHelp")),
                  amount("stroke", text("stroke"), text("strokeHelp"), STROKE, 0.05),
                  time(text("endToEndHelp"), 0.2),
                  part(STROKE.most()),
                  fingers())),
          new DeviceKind(
              "vacuum",
              text("vacuumTitle"),
              SIGNALS,
              List.of(
                  new DeviceField.Wire("suck", text("suck"), text("suckHelp"), false, true),
                  told("holds", text("holds"), text("holdsHelp")),
                  time(text("vacuumTimeHelp"), 0.15),
                  new DeviceField.Flag("part", text("part"), text("partThereHelp"), false),
                  cup())),
          new DeviceKind(
              "door",
              text("doorTitle"),
              SIGNALS,
              List.of(close(), open(), closed(), opened(), time(text("endToEndHelp"), 2), leaf())),
          sensor(
              "light-barrier",
              text("lightBarrierTitle"),
              place("from", text("from"), text("beamFromHelp")),
              place("to", text("to"), text("beamToHelp")),
              amount("radius", text("radius"), text("beamRadiusHelp"), DISTANCE, 0.01)),
          sensor(
              "proximity",
              text("proximityTitle"),
              place("at", text("at"), text("whereItIsHelp")),
              wanted("range", text("range"), text("rangeHelp"), DISTANCE)),
          sensor(
              "area",
              text("areaTitle"),
              place("min", text("least"), text("leastHelp")),
              place("max", text("greatest"), text("greatestHelp"))),
          pressed("limit-switch", text("limitSwitchTitle")),
          pressed("button", text("buttonTitle")),
          new DeviceKind(
              "lamp",
              text("lampTitle"),
              text("reachedOutput"),
              List.of(
                  new DeviceField.Wire(
                      "signal", text("signal"), text("lampSignalHelp"), false, true),
                  new DeviceField.Spot(
                      "at",
                      text("at"),
                      text("lampPlaceHelp"),
                      text("lampWithoutPlace"),
                      FIRST_LAMP,
                      POSITION,
                      ROTATION))),
          new DeviceKind(
              "belt",
              text("beltTitle"),
              text("reachedOutputAndEncoder"),
              List.of(
                  new DeviceField.Subject("object", text("box"), text("beltBoxHelp"), false),
                  wanted("speed", text("speed"), text("beltSpeedHelp"), new Range(-2, 2, "m/s")),
                  amount(
                      "acceleration",
                      text("acceleration"),
                      text("beltAccelerationHelp"),
                      new Range(0.01, 100, "m/s^2"),
                      1),
                  new DeviceField.Wire("run", text("run"), text("beltRunHelp"), false, false),
                  optional(
                      "encoder",
                      text("encoder"),
                      text("encoderHelp"),
                      new Range(0, 1, ""),
                      true,
                      text("withoutNone")),
                  optional(
                      "ticks",
                      text("ticksPerMetre"),
                      text("ticksHelp"),
                      new Range(1, 100_000, "ticks/m"),
                      false,
                      text("withoutNone")))),
          new DeviceKind(
              "source",
              text("sourceTitle"),
              text("reachedOutput"),
              List.of(
                  new DeviceField.Subject("object", text("part"), text("sourcePartHelp"), true),
                  optional(
                      "every",
                      text("every"),
                      text("everyHelp"),
                      new Range(0.01, 3600, "s"),
                      false,
                      text("notByTime")),
                  new DeviceField.Wire("when", text("when"), text("whenHelp"), false, false),
                  whole(
                      "count",
                      text("count"),
                      text("sourceCountHelp"),
                      new Range(1, MAX_PARTS, ""),
                      10))),
          new DeviceKind(
              "sink",
              text("sinkTitle"),
              "",
              List.of(
                  place("min", text("least"), text("leastHelp")),
                  place("max", text("greatest"), text("greatestHelp")))),
          camera(),
          modbus(),
          ethernetIp(),
          rail());

  /** Copies the list. */
  public DeviceKind {
    fields = List.copyOf(fields);
  }

  /** The kind that files call so. */
  public static Optional<DeviceKind> of(String type) {
    return ALL.stream().filter(each -> each.type.equals(type)).findFirst();
  }

  /** Whether a device of it needs nothing but its name. */
  public boolean plain() {
    return fields.stream().noneMatch(DeviceField::required);
  }

  /** Whether a device of it is wired to signals. */
  boolean wired() {
    return fields.stream().anyMatch(DeviceField.Wire.class::isInstance);
  }

  private static DeviceKind twoFinger(
      String type, String title, String reached, boolean activated) {
    return new DeviceKind(
        type,
        title,
        reached,
        List.of(
            new DeviceField.Flag("activated", text("activated"), text("activatedHelp"), activated),
            part(DeviceSetup.TwoFinger.STROKE_M),
            fingers()));
  }

  private static DeviceKind procedures(String type, String title, double strokeM) {
    return new DeviceKind(
        type, title, text("reachedProcedures"), List.of(part(strokeM), fingers()));
  }

  private static DeviceKind camera() {
    return new DeviceKind(
        "camera",
        text("cameraTitle"),
        text("reachedSocketAndProcedures"),
        List.of(
            place("min", text("least"), text("viewLeastHelp")),
            place("max", text("greatest"), text("viewGreatestHelp")),
            new DeviceField.Subjects("objects", text("objects"), text("objectsHelp"), MAX_NAMES),
            new DeviceField.Spot(
                "at",
                text("at"),
                text("cameraPlaceHelp"),
                text("cameraWithoutPlace"),
                FIRST_CAMERA,
                POSITION,
                ROTATION),
            new DeviceField.Flag("occlusion", text("occlusion"), text("occlusionHelp"), false),
            whole("port", text("port"), text("socketPortHelp"), PORT, 50_100),
            whole("rpc", text("proceduresPort"), text("proceduresPortHelp"), PORT, 50_101),
            amount("noise", text("noise"), text("noiseHelp"), new Range(0, 0.1, "m"), 0),
            amount(
                "turn_noise",
                text("noiseOfTurns"),
                text("turnNoiseHelp"),
                new Range(0, 0.5, "rad"),
                0),
            whole("seed", text("seed"), text("seedHelp"), new Range(0, 1_000_000, ""), 0)));
  }

  private static DeviceKind modbus() {
    return new DeviceKind(
        "modbus",
        text("modbusTitle"),
        text("reachedModbus"),
        List.of(
            new DeviceField.Words(
                "address", text("address"), text("addressHelp"), "192.168.0.20", true),
            optional(
                "unit",
                text("unit"),
                text("unitHelp"),
                new Range(0, 255, ""),
                true,
                text("allUnits")),
            whole("coils", text("coils"), COUNTED, COUNT, FIRST_COUNT),
            whole("inputs", text("inputs"), COUNTED, COUNT, FIRST_COUNT),
            whole("registers", text("registers"), COUNTED, COUNT, FIRST_COUNT),
            whole("input_registers", text("inputRegisters"), COUNTED, COUNT, FIRST_COUNT),
            whole(
                "first",
                text("firstAddress"),
                text("firstAddressHelp"),
                new Range(0, 65_535, ""),
                0),
            new DeviceField.Values(
                "values",
                text("values"),
                text("modbusValuesHelp"),
                "register[3] = 17, coil[0] = 1"),
            optional(
                "port", text("port"), text("modbusPortHelp"), PORT, true, text("withoutNone"))));
  }

  private static DeviceKind ethernetIp() {
    return new DeviceKind(
        "ethernetip",
        text("ethernetIpTitle"),
        text("reachedRegisters"),
        List.of(
            amount(
                "interval",
                text("interval"),
                text("intervalHelp"),
                new Range(0.002, 10, "s"),
                DeviceSetup.EthernetIp.INTERVAL_S),
            new DeviceField.Values(
                "values",
                text("values"),
                text("ethernetIpValuesHelp"),
                "input_integer_register[3] = 17")));
  }

  private static DeviceKind rail() {
    return new DeviceKind(
        "rail",
        text("railTitle"),
        text("reachedInputs"),
        List.of(
            new DeviceField.Subject("object", text("object"), text("railObjectHelp"), true),
            new DeviceField.Direction(
                "along", text("along"), text("alongHelp"), new Range(-10, 10, "")),
            wanted("travel", text("travel"), text("travelHelp"), DISTANCE),
            amount(
                "friction",
                text("friction"),
                text("railFrictionHelp"),
                new Range(0, 10_000, "N"),
                5),
            amount(
                "damping", text("damping"), text("dampingHelp"), new Range(0, 100_000, "N s/m"), 0),
            told("closed", text("closed"), text("railClosedHelp")),
            told("opened", text("opened"), text("railOpenedHelp"))));
  }

  private static DeviceField leaf() {
    DeviceField object = new DeviceField.Subject("object", text("object"), text("leafHelp"), true);
    return new DeviceField.Choice(
        text("moves"),
        text("movesHelp"),
        List.of(
            new DeviceField.Choice.Way(text("movesNothing"), "", List.of()),
            new DeviceField.Choice.Way(
                text("movesSliding"),
                "slides",
                List.of(
                    object,
                    new DeviceField.Direction(
                        "slides", text("slides"), text("slidesHelp"), POSITION),
                    amount(
                        "force",
                        text("force"),
                        text("leafForceHelp"),
                        new Range(1, 10_000, "N"),
                        150))),
            new DeviceField.Choice.Way(
                text("movesTurning"),
                "turns",
                List.of(
                    object,
                    place("hinge", text("hinge"), text("hingeHelp")),
                    new DeviceField.Direction(
                        "turns",
                        text("turns"),
                        text("turnsHelp"),
                        new Range(-Math.PI, Math.PI, "rad")),
                    amount(
                        "torque",
                        text("torque"),
                        text("leafTorqueHelp"),
                        new Range(0.1, 10_000, "Nm"),
                        50)))));
  }

  private static DeviceKind pressed(String type, String title) {
    return new DeviceKind(
        type,
        title,
        text("reachedInput"),
        List.of(
            new DeviceField.Wire("signal", text("signal"), text("sensorSignalHelp"), true, true),
            new DeviceField.Flag("inverted", text("inverted"), text("pressedInvertedHelp"), false),
            place("min", text("least"), text("leastHelp")),
            place("max", text("greatest"), text("greatestHelp"))));
  }

  private static DeviceKind sensor(String type, String title, DeviceField... zone) {
    return new DeviceKind(
        type,
        title,
        text("reachedInput"),
        Stream.concat(
                Stream.of(
                    new DeviceField.Wire(
                        "signal", text("signal"), text("sensorSignalHelp"), true, true),
                    new DeviceField.Flag(
                        "inverted", text("inverted"), text("sensorInvertedHelp"), false)),
                Stream.of(zone))
            .toList());
  }

  private static DeviceField close() {
    return new DeviceField.Wire("close", text("close"), text("closeHelp"), false, true);
  }

  private static DeviceField open() {
    return new DeviceField.Wire("open", text("open"), text("openHelp"), false, false);
  }

  private static DeviceField closed() {
    return told("closed", text("closed"), text("endSwitchHelp"));
  }

  private static DeviceField opened() {
    return told("opened", text("opened"), text("endSwitchHelp"));
  }

  private static DeviceField told(String key, String title, String help) {
    return new DeviceField.Wire(key, title, help, true, false);
  }

  private static DeviceField time(String help, double standingS) {
    return amount("time", text("time"), help, TIME, standingS);
  }

  private static DeviceField fingers() {
    GripperSetup.Grip.Pads plain = GripperSetup.Grip.Pads.DEFAULT;
    return new DeviceField.Group(
        "fingers",
        text("fingertips"),
        text("gripHelp"),
        List.of(
            spot(text("fingersSpotHelp")),
            amount(
                "width",
                text("width"),
                text("padWidthHelp"),
                GripperSetup.Grip.LENGTH,
                plain.widthM()),
            amount(
                "length",
                text("length"),
                text("padLengthHelp"),
                GripperSetup.Grip.LENGTH,
                plain.lengthM()),
            friction()));
  }

  private static DeviceField cup() {
    GripperSetup.Grip.Cup plain = GripperSetup.Grip.Cup.DEFAULT;
    return new DeviceField.Group(
        "cup",
        text("cup"),
        text("gripHelp"),
        List.of(
            spot(text("cupSpotHelp")),
            amount(
                "radius",
                text("radius"),
                text("lipRadiusHelp"),
                GripperSetup.Grip.LENGTH,
                plain.radiusM()),
            amount(
                "reach",
                text("reach"),
                text("reachHelp"),
                GripperSetup.Grip.LENGTH,
                plain.reachM()),
            amount(
                "force",
                text("force"),
                text("holdForceHelp"),
                GripperSetup.Grip.FORCE,
                plain.forceN()),
            friction()));
  }

  private static DeviceField spot(String help) {
    return new DeviceField.Spot(
        "at", text("at"), help, text("spotWithoutPlace"), FIRST_HAND, SPOT, ROTATION);
  }

  private static DeviceField friction() {
    return amount(
        "friction",
        text("friction"),
        text("coefficient"),
        GripperSetup.FRICTION,
        GripperSetup.RUBBER);
  }

  private static DeviceField part(double maxPartWidthM) {
    return amount("part", text("part"), text("partWidthHelp"), new Range(0, maxPartWidthM, "m"), 0);
  }

  private static DeviceField amount(
      String key, String title, String help, Range range, double standing) {
    return new DeviceField.Amount(
        key, title, help, range, OptionalDouble.of(standing), false, false, "");
  }

  private static DeviceField whole(
      String key, String title, String help, Range range, double standing) {
    return new DeviceField.Amount(
        key, title, help, range, OptionalDouble.of(standing), false, true, "");
  }

  /** A number that must be there. */
  private static DeviceField wanted(String key, String title, String help, Range range) {
    return new DeviceField.Amount(key, title, help, range, OptionalDouble.empty(), true, false, "");
  }

  /** A number that may be left out, which means that there is nothing of that. */
  private static DeviceField optional(
      String key, String title, String help, Range range, boolean whole, String without) {
    return new DeviceField.Amount(
        key, title, help, range, OptionalDouble.empty(), false, whole, without);
  }

  private static DeviceField place(String key, String title, String help) {
    return new DeviceField.Place(key, title, help, POSITION);
  }
}
