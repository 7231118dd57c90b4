package org.pendant.controller.installation.urp;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.pendant.controller.box.Inertia;
import org.pendant.controller.installation.BaseMounting;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.installation.NamedPayload;
import org.pendant.controller.installation.NamedTool;
import org.pendant.controller.installation.SignalUse;
import org.pendant.controller.io.InputAction;
import org.pendant.controller.io.RunStateAction;
import org.pendant.controller.packedxml.XmlElement;
import org.pendant.controller.world.Vector3;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;

/** Takes out of one file what is known of its form. */
final class InstallationReader {
  /** What the only payload of older files is called here. */
  private static final String ONLY_PAYLOAD = "Payload";

  private static final Set<String> NOT_NEEDED = Set.of("Version");

  /** Elements with names of signals, one after the other, and what the signals are called here. */
  private static final List<Bank> BANKS =
      List.of(
          new Bank("DigitalInputNames", "digital_in", 8),
          new Bank("DigitalOutputNames", "digital_out", 8),
          new Bank("ConfigurableInputNames", "configurable_in", 8),
          new Bank("ConfigurableOutputNames", "configurable_out", 8),
          new Bank("ToolDigitalInputNames", "tool_in", 2),
          new Bank("ToolDigitalOutputNames", "tool_out", 2),
          new Bank("AnalogInputNames", "analog_in", 2),
          new Bank("AnalogOutputNames", "analog_out", 2));

  private record Bank(String element, String name, int size) {}

  private final XmlElement root;
  private final List<String> remarks = new ArrayList<>();
  private final List<String> understood = new ArrayList<>(NOT_NEEDED);

  InstallationReader(XmlElement root) {
    this.root = root;
  }

  ImportedInstallation read() {
    Installation none = Installation.NONE;
    Optional<XmlElement> tools = top("TCPSettings", "TCPSettingsImpl");
    List<NamedTool> tcps = tools.map(this::tools).orElse(List.of());
    List<NamedPayload> payloads = new ArrayList<>();
    String activePayload = payloads(tools, payloads);
    Installation installation =
        new Installation(
            none.robot(),
            tcps,
            tools
                .map(each -> each.text("activePose"))
                .filter(name -> tcps.stream().anyMatch(each -> each.name().equals(name)))
                .orElse(""),
            payloads,
            activePayload,
            mounting(),
            signals(),
            none.wiring(),
            none.features(),
            home().orElse(none.homeRad()),
            none.variables(),
            none.startUp(),
            none.safety(),
            none.conveyors(),
            none.modbus(),
            none.ethernetIpLoss(),
            none.transitionHardness());
    tellTheRest();
    return new ImportedInstallation(installation, remarks);
  }

  private Optional<XmlElement> top(String... names) {
    Optional<XmlElement> found = root.child(names);
    found.ifPresent(each -> understood.add(each.name()));
    return found;
  }

  private List<XmlElement> below(XmlElement element, String name) {
    List<XmlElement> found = new ArrayList<>();
    element.forEach(
        each -> {
          if (each.name().equals(name)) {
            found.add(each);
          }
        });
    return found;
  }

  private List<NamedTool> tools(XmlElement settings) {
    List<NamedTool> tools = new ArrayList<>();
    for (XmlElement each : below(settings, "tcp")) {
      double[] offset = numbers(each.text("offset"), Pose.SIZE);
      if (offset.length == 0 || each.text("name").isEmpty()) {
        remarks.add("line " + each.line() + ": this TCP has no name or no offset of six numbers");
      } else {
        tools.add(new NamedTool(each.text("name"), Pose.of(offset)));
      }
    }
    return tools;
  }

  /** Adds the payloads; answers the name of the active one. */
  private String payloads(Optional<XmlElement> tools, List<NamedPayload> payloads) {
    String active = "";
    Optional<XmlElement> settings = top("PayloadSettings");
    for (XmlElement each : settings.map(found -> below(found, "Payload")).orElse(List.of())) {
      Optional<NamedPayload> payload =
          payload(each.text("name"), each, each.text("mass"), each.text("centerOfGravity"));
      payload.ifPresent(payloads::add);
      if (payload.isPresent() && each.text("defaultPayload").equals("true")) {
        active = payload.get().name();
      }
    }
    if (payloads.isEmpty() && tools.isPresent() && !tools.get().text("toolPayload").isEmpty()) {
      XmlElement older = tools.get();
      String mass = older.text("toolPayload");
      String cog = older.attribute("toolPayloadCenterOfGravity").orElse("0, 0, 0");
      Optional<NamedPayload> payload = payload(ONLY_PAYLOAD, older, mass, cog);
      payload.ifPresent(payloads::add);
      active = payload.map(NamedPayload::name).orElse("");
    }
    return active;
  }

  private Optional<NamedPayload> payload(String name, XmlElement where, String mass, String cog) {
    double[] massKg = numbers(mass, 1);
    double[] cogM = numbers(cog, 3);
    if (name.isEmpty() || massKg.length == 0 || cogM.length == 0) {
      remarks.add("line " + where.line() + ": this payload has no name, mass or centre of gravity");
      return Optional.empty();
    }
    return Optional.of(
        new NamedPayload(name, massKg[0], new Vector3(cogM[0], cogM[1], cogM[2]), Inertia.NONE));
  }

  /** The view of the arm on the screen is turned as the arm is mounted. */
  private BaseMounting mounting() {
    Optional<XmlElement> features = top("GeomFeatures", "Features");
    if (features.isPresent()) {
      remarks.add(
          "line "
              + features.get().line()
              + ": features are not understood, apart from how the base is mounted; programs bring"
              + " those that they use");
      for (XmlElement each : below(features.get(), "WorldtoMarshal")) {
        double[] tilt = numbers(each.text("tiltAngle"), 1);
        double[] base = numbers(each.text("baseAngle"), 1);
        if (tilt.length == 1 && base.length == 1) {
          return new BaseMounting(tilt[0], base[0]);
        }
      }
    }
    return BaseMounting.FLOOR;
  }

  private List<SignalUse> signals() {
    List<SignalUse> uses = new ArrayList<>();
    Optional<XmlElement> ios = top("IOs");
    for (Bank bank : BANKS) {
      String names =
          ios.flatMap(each -> each.child(bank.element()))
              .map(each -> each.text("value"))
              .orElse("");
      List<String> each = List.of(names.split(",", -1));
      for (int i = 0; i < Math.min(each.size(), bank.size()); i++) {
        if (!each.get(i).isBlank()) {
          uses.add(
              new SignalUse(
                  bank.name() + "[" + i + "]",
                  each.get(i).strip(),
                  InputAction.DEFAULT,
                  RunStateAction.PRESERVE));
        }
      }
    }
    return uses;
  }

  private Optional<Joints> home() {
    Optional<XmlElement> home = top("SafeHomeSettings");
    double[] position = numbers(home.map(each -> each.text("position")).orElse(""), Joints.COUNT);
    return position.length == 0 ? Optional.empty() : Optional.of(Joints.of(position));
  }

  /** Numbers with commas between; none if there are not so many. */
  private static double[] numbers(String text, int count) {
    try {
      double[] numbers =
          Arrays.stream(text.split(",", -1)).mapToDouble(Double::parseDouble).toArray();
      boolean right = numbers.length == count && Arrays.stream(numbers).allMatch(Double::isFinite);
      return right ? numbers : new double[0];
    } catch (NumberFormatException e) {
      return new double[0];
    }
  }

  private void tellTheRest() {
    String rest =
        root.children().stream()
            .map(XmlElement::name)
            .filter(each -> !understood.contains(each))
            .distinct()
            .collect(Collectors.joining(", "));
    if (!rest.isEmpty()) {
      remarks.add("not understood, and as in a new installation: " + rest);
    }
  }
}
