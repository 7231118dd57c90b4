package org.pendant.controller.device;

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

  private static final String SIGNALS = "outputs and inputs";
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

  private static final String COUNTED = "how many there are";
  private static final Range COUNT = new Range(0, 1000, "");
  private static final double FIRST_COUNT = 16;
  private static final Range PORT = new Range(1024, 65_535, "");

  /** All kinds, as documentation lists them. */
  public static final List<DeviceKind> ALL =
      List.of(
          twoFinger("two-finger", "Two-finger gripper", "a socket to 127.0.0.1:63352", true),
          twoFinger(
              "two-finger-tool",
              "Two-finger gripper by Modbus RTU",
              "Modbus RTU on the serial line of the tool",
              false),
          procedures("rg", "Gripper rg, 110 mm", DeviceSetup.RpcGripper.RG_STROKE_M),
          procedures("2fg", "Gripper 2fg, 39 mm", DeviceSetup.RpcGripper.TWO_FG_STROKE_M),
          new DeviceKind(
              "gripper",
              "Gripper driven by outputs",
              SIGNALS,
              List.of(
                  close(),
                  open(),
                  closed(),
                  opened(),
                  told("gripped", "Gripped", "the input that tells that it holds something"),
                  amount("stroke", "Stroke", "how far it opens", STROKE, 0.05),
                  time("from end to end", 0.2),
                  part(STROKE.most()),
                  fingers())),
          new DeviceKind(
              "vacuum",
              "Vacuum gripper",
              SIGNALS,
              List.of(
                  new DeviceField.Wire("suck", "Suck", "the output that sucks", false, true),
                  told("holds", "Holds", "the input that tells that it holds something"),
                  time("in which the vacuum builds up, and goes", 0.15),
                  new DeviceField.Flag("part", "Part", "there is a part to hold", false),
                  cup())),
          new DeviceKind(
              "door",
              "Door",
              SIGNALS,
              List.of(close(), open(), closed(), opened(), time("from end to end", 2), leaf())),
          sensor(
              "light-barrier",
              "Light barrier",
              place("from", "From", "one end of the beam"),
              place("to", "To", "the other end of the beam"),
              amount("radius", "Radius", "how near to the beam is seen", DISTANCE, 0.01)),
          sensor(
              "proximity",
              "Proximity sensor",
              place("at", "At", "where it is"),
              wanted("range", "Range", "how near is seen", DISTANCE)),
          sensor(
              "area",
              "Watched area",
              place("min", "Least", "the corner with the least numbers"),
              place("max", "Greatest", "the corner with the greatest numbers")),
          pressed("limit-switch", "Limit switch"),
          pressed("button", "Button"),
          new DeviceKind(
              "lamp",
              "Lamp",
              "an output",
              List.of(
                  new DeviceField.Wire("signal", "Signal", "that it shows", false, true),
                  new DeviceField.Spot(
                      "at",
                      "At",
                      "where it is, to be seen",
                      "Not seen in 3D",
                      FIRST_LAMP,
                      POSITION,
                      ROTATION))),
          new DeviceKind(
              "belt",
              "Belt",
              "an output, and an encoder",
              List.of(
                  new DeviceField.Subject(
                      "object", "Box", "whose surface runs along its own x", false),
                  wanted("speed", "Speed", "while it runs", new Range(-2, 2, "m/s")),
                  amount(
                      "acceleration",
                      "Acceleration",
                      "with which it starts and stops",
                      new Range(0.01, 100, "m/s^2"),
                      1),
                  new DeviceField.Wire(
                      "run",
                      "Run",
                      "the output that has it run; without one it always does",
                      false,
                      false),
                  optional(
                      "encoder",
                      "Encoder",
                      "the one that it turns",
                      new Range(0, 1, ""),
                      true,
                      "none"),
                  optional(
                      "ticks",
                      "Ticks per m",
                      "of the encoder",
                      new Range(1, 100_000, "ticks/m"),
                      false,
                      "none"))),
          new DeviceKind(
              "source",
              "Source of parts",
              "an output",
              List.of(
                  new DeviceField.Subject(
                      "object", "Part", "another one like it comes where it was at first", true),
                  optional(
                      "every",
                      "Every",
                      "how often",
                      new Range(0.01, 3600, "s"),
                      false,
                      "not by time"),
                  new DeviceField.Wire(
                      "when", "When", "the output that has one come when it rises", false, false),
                  whole(
                      "count",
                      "Count",
                      "how many there are at most, the object itself among them",
                      new Range(1, MAX_PARTS, ""),
                      10))),
          new DeviceKind(
              "sink",
              "Sink of parts",
              "",
              List.of(
                  place("min", "Least", "the corner with the least numbers"),
                  place("max", "Greatest", "the corner with the greatest numbers"))),
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
            new DeviceField.Flag(
                "activated", "Activated", "it was activated before programs begin", activated),
            part(DeviceSetup.TwoFinger.STROKE_M),
            fingers()));
  }

  private static DeviceKind procedures(String type, String title, double strokeM) {
    return new DeviceKind(
        type, title, "XML-RPC at http://localhost:41414", List.of(part(strokeM), fingers()));
  }

  private static DeviceKind camera() {
    return new DeviceKind(
        "camera",
        "Camera",
        "a socket and XML-RPC at its ports",
        List.of(
            place("min", "Least", "the corner of its view with the least numbers"),
            place("max", "Greatest", "the corner of its view with the greatest numbers"),
            new DeviceField.Subjects(
                "objects", "Objects", "the names of those that it knows", MAX_NAMES),
            new DeviceField.Spot(
                "at",
                "At",
                "where it is, if it tells poses in its own frame",
                "Poses in the base frame",
                FIRST_CAMERA,
                POSITION,
                ROTATION),
            new DeviceField.Flag(
                "occlusion", "Occlusion", "it does not see what others hide from there", false),
            whole("port", "Port", "of its socket", PORT, 50_100),
            whole("rpc", "XML-RPC port", "of its procedures", PORT, 50_101),
            amount(
                "noise", "Noise", "standard deviation along each axis", new Range(0, 0.1, "m"), 0),
            amount(
                "turn_noise",
                "Noise of turns",
                "standard deviation about each axis",
                new Range(0, 0.5, "rad"),
                0),
            whole("seed", "Seed", "of the noise", new Range(0, 1_000_000, ""), 0)));
  }

  private static DeviceKind modbus() {
    return new DeviceKind(
        "modbus",
        "PLC by Modbus",
        "Modbus signals at its address",
        List.of(
            new DeviceField.Words(
                "address",
                "Address",
                "host, or host:port, by which programs reach it",
                "192.168.0.20",
                true),
            optional(
                "unit",
                "Unit",
                "that it answers to, all of them without",
                new Range(0, 255, ""),
                true,
                "all"),
            whole("coils", "Coils", COUNTED, COUNT, FIRST_COUNT),
            whole("inputs", "Inputs", COUNTED, COUNT, FIRST_COUNT),
            whole("registers", "Registers", COUNTED, COUNT, FIRST_COUNT),
            whole("input_registers", "Input registers", COUNTED, COUNT, FIRST_COUNT),
            whole("first", "First address", "of each of these", new Range(0, 65_535, ""), 0),
            new DeviceField.Values(
                "values", "Values", "what is not 0 at first", "register[3] = 17, coil[0] = 1"),
            optional(
                "port",
                "Port",
                "of this controller where other computers reach it",
                PORT,
                true,
                "none")));
  }

  private static DeviceKind ethernetIp() {
    return new DeviceKind(
        "ethernetip",
        "PLC by EtherNet/IP",
        "registers",
        List.of(
            amount(
                "interval",
                "Interval",
                "between two packets, each way",
                new Range(0.002, 10, "s"),
                DeviceSetup.EthernetIp.INTERVAL_S),
            new DeviceField.Values(
                "values",
                "Values",
                "what it writes at first that is not 0",
                "input_integer_register[3] = 17")));
  }

  private static DeviceKind rail() {
    return new DeviceKind(
        "rail",
        "Rail",
        "inputs",
        List.of(
            new DeviceField.Subject("object", "Object", "which goes along it", true),
            new DeviceField.Direction(
                "along",
                "Along",
                "direction from where the object is at first",
                new Range(-10, 10, "")),
            wanted("travel", "Travel", "how far the object goes", DISTANCE),
            amount(
                "friction", "Friction", "what it takes to move it", new Range(0, 10_000, "N"), 5),
            amount("damping", "Damping", "force for each m/s", new Range(0, 100_000, "N s/m"), 0),
            told("closed", "Closed", "the input of the switch where it is at first"),
            told("opened", "Opened", "the input of the switch at the other end")));
  }

  private static DeviceField leaf() {
    DeviceField object =
        new DeviceField.Subject("object", "Object", "which stands open at first", true);
    return new DeviceField.Choice(
        "Moves",
        "what it moves in the scene",
        List.of(
            new DeviceField.Choice.Way("nothing", "", List.of()),
            new DeviceField.Choice.Way(
                "an object that slides",
                "slides",
                List.of(
                    object,
                    new DeviceField.Direction("slides", "Slides", "from open to closed", POSITION),
                    amount(
                        "force",
                        "Force",
                        "with which it moves at most",
                        new Range(1, 10_000, "N"),
                        150))),
            new DeviceField.Choice.Way(
                "an object that turns",
                "turns",
                List.of(
                    object,
                    place("hinge", "Hinge", "a point on its line"),
                    new DeviceField.Direction(
                        "turns",
                        "Turns",
                        "from open to closed, as a rotation vector",
                        new Range(-Math.PI, Math.PI, "rad")),
                    amount(
                        "torque",
                        "Torque",
                        "with which it turns at most",
                        new Range(0.1, 10_000, "Nm"),
                        50)))));
  }

  private static DeviceKind pressed(String type, String title) {
    return new DeviceKind(
        type,
        title,
        "an input",
        List.of(
            new DeviceField.Wire("signal", "Signal", "the input that it sets", true, true),
            new DeviceField.Flag(
                "inverted", "Inverted", "the input is high while nothing presses it", false),
            place("min", "Least", "the corner with the least numbers"),
            place("max", "Greatest", "the corner with the greatest numbers")));
  }

  private static DeviceKind sensor(String type, String title, DeviceField... zone) {
    return new DeviceKind(
        type,
        title,
        "an input",
        Stream.concat(
                Stream.of(
                    new DeviceField.Wire("signal", "Signal", "the input that it sets", true, true),
                    new DeviceField.Flag(
                        "inverted", "Inverted", "the input is high while it sees nothing", false)),
                Stream.of(zone))
            .toList());
  }

  private static DeviceField close() {
    return new DeviceField.Wire("close", "Close", "the output that closes it", false, true);
  }

  private static DeviceField open() {
    return new DeviceField.Wire(
        "open",
        "Open",
        "the output that opens it; without one it opens while the other is low",
        false,
        false);
  }

  private static DeviceField closed() {
    return told("closed", "Closed", "the input of the end switch there");
  }

  private static DeviceField opened() {
    return told("opened", "Opened", "the input of the end switch there");
  }

  private static DeviceField told(String key, String title, String help) {
    return new DeviceField.Wire(key, title, help, true, false);
  }

  private static DeviceField time(String help, double standingS) {
    return amount("time", "Time", help, TIME, standingS);
  }

  private static DeviceField fingers() {
    GripperSetup.Grip.Pads plain = GripperSetup.Grip.Pads.DEFAULT;
    return new DeviceField.Group(
        "fingers",
        "Fingertips",
        "what grips objects that move",
        List.of(
            spot("middle between the fingertips"),
            amount(
                "width", "Width", "of the pads, along x", GripperSetup.Grip.LENGTH, plain.widthM()),
            amount(
                "length",
                "Length",
                "of the pads, along z",
                GripperSetup.Grip.LENGTH,
                plain.lengthM()),
            friction()));
  }

  private static DeviceField cup() {
    GripperSetup.Grip.Cup plain = GripperSetup.Grip.Cup.DEFAULT;
    return new DeviceField.Group(
        "cup",
        "Cup",
        "what grips objects that move",
        List.of(
            spot("middle of its lip"),
            amount("radius", "Radius", "of its lip", GripperSetup.Grip.LENGTH, plain.radiusM()),
            amount(
                "reach",
                "Reach",
                "how far from it a surface may be",
                GripperSetup.Grip.LENGTH,
                plain.reachM()),
            amount(
                "force", "Force", "with which it holds", GripperSetup.Grip.FORCE, plain.forceN()),
            friction()));
  }

  private static DeviceField spot(String what) {
    return new DeviceField.Spot(
        "at",
        "At",
        what + ", in the flange: z goes on, fingers close along y",
        "At the active TCP",
        FIRST_HAND,
        SPOT,
        ROTATION);
  }

  private static DeviceField friction() {
    return amount(
        "friction", "Friction", "coefficient", GripperSetup.FRICTION, GripperSetup.RUBBER);
  }

  private static DeviceField part(double maxPartWidthM) {
    return amount(
        "part", "Part", "width of a part between the fingers", new Range(0, maxPartWidthM, "m"), 0);
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
