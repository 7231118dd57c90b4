package org.pendant.desktop.cell;

import static org.pendant.desktop.cell.CellTexts.text;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.function.BinaryOperator;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.swing.JButton;
import org.pendant.controller.device.DeviceField;
import org.pendant.controller.device.DeviceKind;
import org.pendant.controller.io.Signal;
import org.pendant.controller.io.SignalBank;
import org.pendant.controller.world.Scene;
import org.pendant.controller.world.SceneObject;
import org.pendant.controller.world.Vector3;
import org.pendant.desktop.scene.DeviceHandles;
import org.pendant.desktop.unit.PoseRows;
import org.pendant.desktop.unit.RotationChoice;
import org.pendant.kit.form.Measure;
import org.pendant.kit.form.Measures;
import org.pendant.kit.form.PartsForm;
import org.pendant.kit.layout.TitledCard;
import org.pendant.kit.text.Messages;
import org.pendant.models.json.Range;
import org.pendant.models.pose.Pose;

/** Device form: a row for each field that devices have, as their kinds declare them. */
final class DeviceForm {
  private static final String NONE = text("noSignal");

  /** How near a new proximity sensor sees, m, and how fast a new belt is, m/s. */
  private static final double FIRST_NUMBER = 0.05;

  /** A source has to say when, in one way or another. */
  private static final String SOURCE = "source";

  /** Each has ports of its own. */
  private static final String CAMERA = "camera";

  /** Of a camera that says none. */
  private static final double FIRST_PORT = 50_100;

  private static final double FIRST_EVERY_S = 2;

  /** Says that an object has to be there first. */
  private static final String NO_SUBJECT = "none";

  private final PartsForm<DeviceText> form;
  private final Measures measures;
  private final RotationChoice rotation;
  private final UnaryOperator<String> signalName;
  private final Supplier<Scene> scene;
  private final Supplier<String> frame;
  private final Supplier<List<WireSignal>> others;
  private final Consumer<String> putAtTcp;
  private final Set<String> kinds = new HashSet<>();

  /**
   * Fills a form.
   *
   * @param measures in which lengths are shown
   * @param rotation how rotations are shown
   * @param signalName the name of a signal such as {@code digital_in[0]}; empty while it has none
   * @param scene whose objects devices work with
   * @param frame what places are in, for people
   * @param others signals of other controllers and of devices, which wires may lead to as well
   * @param putAtTcp moves the place of a key, or all of the chosen device, to the TCP
   */
  DeviceForm(
      PartsForm<DeviceText> form,
      Measures measures,
      RotationChoice rotation,
      UnaryOperator<String> signalName,
      Supplier<Scene> scene,
      Supplier<String> frame,
      Supplier<List<WireSignal>> others,
      Consumer<String> putAtTcp) {
    this.scene = scene;
    this.frame = frame;
    this.others = others;
    this.putAtTcp = putAtTcp;
    this.form = form.in(measures).telling(why -> ShownRange.of(why, measures));
    this.measures = measures;
    this.rotation = rotation;
    this.signalName = signalName;
    form.text("name", text("name"), DeviceText::name, (device, name) -> device.named(name.strip()));
  }

  /** Has rows for the kinds of these devices: made when the first one of a kind is there. */
  void provide(List<DeviceText> devices) {
    for (DeviceText device : devices) {
      DeviceKind.of(device.type()).filter(kind -> kinds.add(kind.type())).ifPresent(this::add);
    }
  }

  private void add(DeviceKind kind) {
    form.naming(kind.type() + "-");
    form.section(
        device -> device.type().equals(kind.type()),
        () -> {
          Part whole = new Part(device -> device, (device, next) -> next, kind.type());
          kind.fields().forEach(each -> addRow(each, whole));
          addPutters(kind);
          form.note(
              kind.reached().isEmpty()
                  ? text("itTakesAwayWhatHasIts")
                  : text("programsReachItBy", kind.reached()));
        });
    form.naming("");
  }

  /** Buttons that put its place, or each end of it, at the TCP. */
  private void addPutters(DeviceKind kind) {
    List<DeviceField> places =
        kind.fields().stream().filter(DeviceField.Place.class::isInstance).toList();
    if (places.isEmpty()) {
      return;
    }
    List<JButton> buttons = new ArrayList<>();
    buttons.add(
        putter(kind, DeviceHandles.WHOLE, text("putAtTcp"), text("putItsMiddleWhereTheTcp")));
    // a corner may have to stay where it is, an end goes anywhere
    places.stream()
        .filter(each -> each.key().equals("from") || each.key().equals("to"))
        .forEach(
            each ->
                buttons.add(
                    putter(
                        kind,
                        each.key(),
                        text("endAtTcp", each.title()),
                        text("putWhereTheTcpIs", each.help()))));
    form.buttons(buttons.toArray(JButton[]::new));
  }

  private JButton putter(DeviceKind kind, String key, String title, String tip) {
    JButton button = new JButton(title);
    TitledCard.compact(button);
    TitledCard.named(
        button, "cell-device-" + kind.type() + (key.isEmpty() ? "" : "-" + key) + "-here", tip);
    button.addActionListener(event -> putAtTcp.accept(key));
    return button;
  }

  /**
   * The part of a device that has some fields: all of it, or an object in it.
   *
   * @param name with which names of fields begin
   */
  private record Part(UnaryOperator<DeviceText> get, BinaryOperator<DeviceText> with, String name) {
    Part inner(String key) {
      return new Part(
          device -> get.apply(device).inner(key),
          (device, next) -> with.apply(device, get.apply(device).withInner(key, next)),
          name + "-" + key);
    }

    DeviceText change(DeviceText device, UnaryOperator<DeviceText> change) {
      return with.apply(device, change.apply(get.apply(device)));
    }
  }

  private void addRow(DeviceField field, Part part) {
    switch (field) {
      case DeviceField.Flag flag ->
          form.check(
              flag.title(),
              Messages.shown(flag.title()),
              Messages.told(Messages.shown(flag.title()), Messages.shown(flag.help())),
              device -> part.get.apply(device).flag(flag.key(), flag.standing()),
              (device, on) ->
                  part.change(device, text -> text.withFlag(flag.key(), on, flag.standing())));
      case DeviceField.Amount amount -> addAmount(amount, part);
      case DeviceField.Wire wire -> addWire(wire, part);
      case DeviceField.Place place ->
          addAxes(place.title(), place.help(), place.key(), place.range(), part);
      case DeviceField.Direction way ->
          addAxes(way.title(), way.help(), way.key(), way.range(), part);
      case DeviceField.Choice choice -> addChoice(choice, part);
      case DeviceField.Words words ->
          form.text(
              words.title(),
              Messages.shown(words.title()),
              Messages.told(Messages.shown(words.title()), Messages.shown(words.help())),
              "",
              device -> part.get.apply(device).text(words.key()),
              (device, typed) ->
                  part.change(device, text -> text.withText(words.key(), typed.strip())));
      case DeviceField.Values values ->
          form.text(
              values.title(),
              Messages.shown(values.title()),
              text(
                  "valuesSuchAs",
                  Messages.shown(values.title()),
                  Messages.shown(values.help()),
                  values.example()),
              values.example(),
              device -> part.get.apply(device).values(values.key()),
              (device, typed) -> part.change(device, text -> text.withValues(values.key(), typed)));
      case DeviceField.Subject subject ->
          form.choice(
              subject.title(),
              Messages.shown(subject.title()),
              Messages.told(Messages.shown(subject.title()), Messages.shown(subject.help())),
              device -> subjects(subject, scene.get()),
              name -> name,
              device -> part.get.apply(device).text(subject.key()),
              (device, name) -> part.change(device, text -> text.withText(subject.key(), name)));
      case DeviceField.Subjects subjects ->
          form.text(
              subjects.title(),
              Messages.shown(subjects.title()),
              text(
                  "withCommasBetween",
                  Messages.shown(subjects.title()),
                  Messages.shown(subjects.help())),
              text("allObjects"),
              device -> String.join(", ", part.get.apply(device).list(subjects.key())),
              (device, names) ->
                  part.change(device, text -> text.withList(subjects.key(), names(names))));
      case DeviceField.Spot spot -> addSpot(spot, part);
      case DeviceField.Group group -> {
        form.heading(Messages.told(Messages.shown(group.title()), Messages.shown(group.help())));
        Part inner = part.inner(group.key());
        form.naming(inner.name + "-");
        group.fields().forEach(each -> addRow(each, inner));
        form.naming(part.name + "-");
      }
    }
  }

  private void addAxes(String title, String help, String key, Range range, Part part) {
    String shown = Messages.shown(title);
    form.heading(() -> text("axesInFrame", shown, Messages.shown(help), frame.get()));
    Measure usual = measure(range);
    Axes.addTo(
        form,
        title,
        shown,
        usual,
        device -> part.get.apply(device).place(key),
        (device, at) -> {
          for (double each : List.of(at.x(), at.y(), at.z())) {
            require(range, each, measures.of(usual));
          }
          return part.change(device, text -> text.withPlace(key, at));
        });
  }

  /** A row for the way, and the fields of each that are there while it is chosen. */
  private void addChoice(DeviceField.Choice choice, Part part) {
    form.choice(
        choice.title(),
        Messages.shown(choice.title()),
        Messages.told(Messages.shown(choice.title()), Messages.shown(choice.help())),
        device -> choice.ways(),
        way -> Messages.shown(way.title()),
        device -> way(choice, part.get.apply(device)),
        (device, way) -> part.change(device, text -> withWay(text, choice, way)));
    for (DeviceField.Choice.Way way : choice.ways()) {
      form.naming(part.name + "-" + way.mark() + "-");
      form.section(
          device -> way(choice, part.get.apply(device)).equals(way),
          () -> way.fields().forEach(each -> addRow(each, part)));
    }
    form.naming(part.name + "-");
  }

  private static DeviceField.Choice.Way way(DeviceField.Choice choice, DeviceText device) {
    return choice.ways().stream()
        .filter(each -> device.has(each.mark()))
        .findFirst()
        .orElse(choice.ways().getFirst());
  }

  /** The device with the fields of another way; those that both have stay as they are. */
  private DeviceText withWay(
      DeviceText device, DeviceField.Choice choice, DeviceField.Choice.Way to) {
    Set<String> kept = new HashSet<>();
    to.fields().forEach(each -> kept.add(each.key()));
    DeviceText next = device;
    for (DeviceField.Choice.Way way : choice.ways()) {
      for (DeviceField field : way.fields()) {
        next = kept.contains(field.key()) ? next : next.withText(field.key(), "");
      }
    }
    for (DeviceField field : to.fields()) {
      if (field.required() && !next.has(field.key())) {
        next = first(next, field, Set.of(), scene.get());
      }
    }
    return next;
  }

  /** Names with commas between. */
  private static List<String> names(String typed) {
    return Arrays.stream(typed.split(",", -1))
        .map(String::strip)
        .filter(each -> !each.isEmpty())
        .toList();
  }

  private void addSpot(DeviceField.Spot spot, Part part) {
    form.check(
        spot.without(),
        Messages.shown(spot.without()),
        Messages.told(Messages.shown(spot.title()), Messages.shown(spot.help())),
        device -> part.get.apply(device).pose(spot.key()).isEmpty(),
        (device, on) ->
            part.change(
                device,
                text ->
                    text.withPose(spot.key(), on ? Optional.empty() : Optional.of(spot.first()))));
    form.section(
        device -> part.get.apply(device).pose(spot.key()).isPresent(),
        () ->
            PoseRows.addTo(
                form,
                part.name + "-" + spot.key(),
                rotation,
                device -> part.get.apply(device).pose(spot.key()).orElse(Pose.ZERO),
                (device, pose) ->
                    part.change(device, text -> text.withPose(spot.key(), Optional.of(pose))),
                device -> true));
  }

  private void addAmount(DeviceField.Amount amount, Part part) {
    Measure usual = measure(amount.range());
    form.optionalNumber(
        amount.title(),
        Messages.shown(amount.title()),
        () -> hint(amount, measures.of(usual)),
        usual,
        amount.standing(),
        Messages.shown(amount.without()),
        device -> part.get.apply(device).number(amount.key()),
        (device, number) -> {
          Measure unit = measures.of(usual);
          if (number.isEmpty() && amount.required()) {
            throw new IllegalArgumentException(text("emptyNumber", unit.symbol()));
          }
          number.ifPresent(value -> require(amount.range(), value, unit));
          if (amount.whole() && number.isPresent() && number.getAsDouble() % 1 != 0) {
            throw new IllegalArgumentException(text("notWhole"));
          }
          return part.change(device, text -> text.withNumber(amount.key(), number));
        });
  }

  private static Measure measure(Range range) {
    return switch (range.unit()) {
      case "m" -> Measure.MILLIMETRE;
      case "s" -> Measure.SECOND;
      case "N" -> Measure.NEWTON;
      case "Nm" -> Measure.NEWTON_METRE;
      case "N s/m" -> Measure.NEWTON_SECOND_PER_METRE;
      case "rad" -> Measure.DEGREE;
      case "m/s" -> Measure.MILLIMETRE_PER_S;
      case "m/s^2" -> Measure.MILLIMETRE_PER_S2;
      default -> Measure.PLAIN;
    };
  }

  /** Such as {@code Time: from end to end, 0.01 to 60 s, 0.2 s where nothing is typed}. */
  private static String hint(DeviceField.Amount amount, Measure unit) {
    OptionalDouble standing = amount.standing();
    String span = span(amount.range(), unit);
    return standing.isPresent()
        ? text(
            "hintWithStanding",
            Messages.shown(amount.title()),
            Messages.shown(amount.help()),
            span,
            unit.words(standing.getAsDouble()))
        : text("hint", Messages.shown(amount.title()), Messages.shown(amount.help()), span);
  }

  private static String span(Range range, Measure unit) {
    return text("span", unit.text(range.least()), unit.words(range.most()));
  }

  private static void require(Range range, double value, Measure unit) {
    if (!range.holds(value)) {
      throw new IllegalArgumentException(text("outside", unit.words(value), span(range, unit)));
    }
  }

  private void addWire(DeviceField.Wire wire, Part part) {
    form.choice(
        wire.title(),
        Messages.shown(wire.title()),
        Messages.told(Messages.shown(wire.title()), Messages.shown(wire.help())),
        device -> withOthers(wire, others.get(), device.name()),
        this::words,
        device -> part.get.apply(device).text(wire.key()),
        (device, signal) -> part.change(device, text -> text.withText(wire.key(), signal)));
  }

  /** Those of the controller, and of others what the device may set or watch; none of its own. */
  static List<String> withOthers(DeviceField.Wire wire, List<WireSignal> others, String device) {
    Stream<String> more =
        others.stream()
            .filter(each -> !wire.input() || each.kind() == WireSignal.Kind.INPUT)
            .map(WireSignal::name)
            .filter(name -> !name.startsWith(device + "."));
    return Stream.concat(signals(wire).stream(), more).toList();
  }

  /** Inputs for what the device sets; for what it watches all there are, outputs first. */
  private static List<String> signals(DeviceField.Wire wire) {
    Stream<SignalBank> banks =
        wire.input()
            ? Arrays.stream(SignalBank.values()).filter(SignalBank::input)
            : Arrays.stream(SignalBank.values())
                .sorted(
                    Comparator.comparing((SignalBank bank) -> bank == SignalBank.FLAG)
                        .thenComparing(SignalBank::input));
    Stream<String> all =
        banks
            .flatMap(bank -> IntStream.range(0, bank.size()).mapToObj(i -> new Signal(bank, i)))
            .map(Signal::toString);
    return Stream.concat(wire.required() ? Stream.of() : Stream.of(""), all).toList();
  }

  private String words(String signal) {
    String name = signal.isEmpty() ? NONE : signalName.apply(signal);
    return signal.isEmpty() || name.isEmpty() ? signal + name : signal + "  " + name;
  }

  /** The names of the objects that a device can work with. */
  private static List<String> subjects(DeviceField.Subject subject, Scene scene) {
    return scene.objects().stream()
        .filter(
            each ->
                subject.moves()
                    ? each.massKg() > 0
                    : each instanceof SceneObject.Box && each.massKg() == 0)
        .map(SceneObject::name)
        .toList();
  }

  /** A device of a kind that a scene can have, where arms reach. */
  static DeviceText fresh(DeviceKind kind, List<DeviceText> others, Scene scene) {
    DeviceText device = DeviceText.of(kind, freshName(kind.type(), others));
    Set<String> used = new HashSet<>();
    others.forEach(each -> used.addAll(each.texts()));
    for (DeviceField field : kind.fields()) {
      if (field.required()) {
        device = first(device, field, used, scene);
      }
    }
    return switch (kind.type()) {
      case SOURCE -> device.withNumber("every", OptionalDouble.of(FIRST_EVERY_S));
      case CAMERA -> withFreePorts(device, others);
      default -> device;
    };
  }

  /** With what a field that must be there begins with. */
  private static DeviceText first(
      DeviceText device, DeviceField field, Set<String> used, Scene scene) {
    return switch (field) {
      case DeviceField.Wire wire -> device.withText(wire.key(), free(wire, used));
      case DeviceField.Amount amount ->
          device.withNumber(amount.key(), OptionalDouble.of(FIRST_NUMBER));
      case DeviceField.Place place ->
          device.withPlace(place.key(), first(place.key(), device.text("object"), scene));
      case DeviceField.Direction way -> device.withPlace(way.key(), first(way.key()));
      case DeviceField.Subject subject ->
          device.withText(
              subject.key(), subjects(subject, scene).stream().findFirst().orElse(NO_SUBJECT));
      case DeviceField.Words words -> device.withText(words.key(), words.example());
      case DeviceField.Flag _,
          DeviceField.Values _,
          DeviceField.Subjects _,
          DeviceField.Spot _,
          DeviceField.Choice _,
          DeviceField.Group _ ->
          device;
    };
  }

  /** With ports that no other camera has. */
  private static DeviceText withFreePorts(DeviceText camera, List<DeviceText> others) {
    double next = 0;
    for (DeviceText other : others) {
      if (other.type().equals(CAMERA)) {
        next = Math.max(next, 1 + other.number("rpc").orElse(FIRST_PORT + 1));
        next = Math.max(next, 1 + other.number("port").orElse(FIRST_PORT));
      }
    }
    return next == 0
        ? camera
        : camera
            .withNumber("port", OptionalDouble.of(next))
            .withNumber("rpc", OptionalDouble.of(next + 1));
  }

  /** Where the object is that a device moves, for its hinge; of others as below. */
  private static Vector3 first(String key, String object, Scene scene) {
    return scene.objects().stream()
        .filter(each -> key.equals("hinge") && each.name().equals(object))
        .findFirst()
        .map(ObjectShape::placeM)
        .orElseGet(() -> first(key));
  }

  /** In front of the base: a beam from side to side, or a box; a way ahead, down or round. */
  private static Vector3 first(String key) {
    return switch (key) {
      case "from" -> new Vector3(0.4, -0.3, 0.2);
      case "to" -> new Vector3(0.4, 0.3, 0.2);
      case "min" -> new Vector3(0.3, -0.1, 0);
      case "max" -> new Vector3(0.5, 0.1, 0.2);
      case "along" -> new Vector3(1, 0, 0);
      case "slides" -> new Vector3(0, 0, -0.3);
      case "turns" -> new Vector3(0, 0, Math.PI / 2);
      default -> new Vector3(0.4, 0, 0.2);
    };
  }

  private static String free(DeviceField.Wire wire, Set<String> used) {
    List<String> all = signals(wire);
    return all.stream().filter(each -> !used.contains(each)).findFirst().orElse(all.getFirst());
  }

  private static String freshName(String type, List<DeviceText> others) {
    String name = type;
    for (int i = 2; isUsed(name, others); i++) {
      name = type + "_" + i;
    }
    return name;
  }

  private static boolean isUsed(String name, List<DeviceText> others) {
    return others.stream().anyMatch(each -> each.name().equals(name));
  }
}
