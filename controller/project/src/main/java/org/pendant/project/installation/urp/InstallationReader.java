package org.pendant.project.installation.urp;

import static org.pendant.project.installation.urp.InstallationUrpTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.pendant.controller.box.Inertia;
import org.pendant.controller.installation.BaseMounting;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.installation.NamedPayload;
import org.pendant.controller.installation.NamedTool;
import org.pendant.controller.world.Vector3;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.project.polyscope.xml.XmlElement;
import org.pendant.project.program.urp.UrpCalibration;

/** Installation reader: takes out of one file what is known of its form. */
final class InstallationReader {
  /** What the only payload of older files is called here. */
  private static final String ONLY_PAYLOAD = "Payload";

  /** What tells nothing that a simulated robot could use. */
  private static final Set<String> NOT_NEEDED =
      Set.of(
          "Version",
          "LastSavedInVersion",
          "ContinuousPulse",
          "ResourceControlSettings",
          "com.ur.view.io.IOServiceImpl",
          "gui.polyscope.setup.treenodes.geom.SetupFeatureContainerNode");

  private final XmlElement root;
  private final List<String> remarks = new ArrayList<>();
  private final List<String> understood = new ArrayList<>(NOT_NEEDED);

  InstallationReader(XmlElement root) {
    this.root = root;
  }

  ImportedInstallation read() {
    Optional<XmlElement> settings =
        top("TCPSettings", "TCPSettingsImpl", "com.ur.view.tcp.domain.TCPSettingsImpl");
    Optional<XmlElement> ios = top("IOs");
    Optional<XmlElement> geometry = top("GeomFeatures", "Features");
    SignalReader signals = new SignalReader(ios, remarks);
    Installation installation =
        Installation.NONE.with(
            parts -> {
              List<NamedTool> tcps = settings.map(this::tools).orElse(List.of());
              parts.tools = tcps;
              parts.activeTool =
                  settings
                      .map(each -> each.text("activePose"))
                      .filter(name -> tcps.stream().anyMatch(each -> each.name().equals(name)))
                      .orElse("");
              List<NamedPayload> payloads = new ArrayList<>();
              parts.activePayload = payloads(settings, payloads);
              parts.payloads = payloads;
              parts.mounting = geometry.map(this::mounting).orElse(BaseMounting.FLOOR);
              parts.features =
                  geometry.map(each -> new FeatureReader(remarks).read(each)).orElse(List.of());
              parts.signals = signals.signals();
              parts.modbus = signals.modbus();
              parts.wiring = new WiringReader(ios, top("ToolCommSettings"), remarks).read();
              parts.homeRad = home().orElse(parts.homeRad);
              parts.controlHost =
                  new ContributionReader(top("Contributions"), remarks).controlHost();
              parts.safety =
                  top("SafetySettings").flatMap(each -> SafetySettingsReader.read(each, remarks));
              parts.transitionHardness = hardness().orElse(parts.transitionHardness);
            });
    Optional<XmlElement> arm = UrpCalibration.element(root);
    arm.ifPresent(each -> understood.add(each.name()));
    actionsOfOlderFiles();
    tellTheRest();
    return new ImportedInstallation(installation, remarks, arm.isPresent());
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
      double[] offset = Rows.numbers(each.text("offset"), Pose.SIZE);
      if (offset.length == 0 || each.text("name").isEmpty()) {
        remarks.add(text("atLine", each.line(), text("tcpIncomplete")));
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
      String cog =
          older
              .attribute("centerOfGravity")
              .or(() -> older.attribute("toolPayloadCenterOfGravity"))
              .orElse("0, 0, 0");
      Optional<NamedPayload> payload = payload(ONLY_PAYLOAD, older, mass, cog);
      payload.ifPresent(payloads::add);
      active = payload.map(NamedPayload::name).orElse("");
    }
    return active;
  }

  private Optional<NamedPayload> payload(String name, XmlElement where, String mass, String cog) {
    double[] massKg = Rows.numbers(mass, 1);
    double[] cogM = Rows.numbers(cog, 3);
    if (name.isEmpty() || massKg.length == 0 || cogM.length == 0) {
      remarks.add(text("atLine", where.line(), text("payloadIncomplete")));
      return Optional.empty();
    }
    return Optional.of(
        new NamedPayload(name, massKg[0], new Vector3(cogM[0], cogM[1], cogM[2]), inertia(where)));
  }

  private Inertia inertia(XmlElement payload) {
    double[] elements = Rows.numbers(payload.text("inertiaParameters"), 6);
    Inertia inertia = elements.length == 0 ? Inertia.NONE : Inertia.of(elements);
    Optional<String> problem = inertia.problem();
    problem.ifPresent(
        why -> remarks.add(text("atLine", payload.line(), text("inertiaLeftOut", why))));
    return problem.isEmpty() ? inertia : Inertia.NONE;
  }

  /** The view of the arm on the screen is turned as the arm is mounted. */
  private BaseMounting mounting(XmlElement features) {
    for (XmlElement each : below(features, "WorldtoMarshal")) {
      double[] tilt = Rows.numbers(each.text("tiltAngle"), 1);
      double[] base = Rows.numbers(each.text("baseAngle"), 1);
      if (tilt.length == 1 && base.length == 1) {
        return new BaseMounting(tilt[0], base[0]);
      }
    }
    return BaseMounting.FLOOR;
  }

  /** How fast the arm slows down when its limits get tighter: 0 for hard, 1 for soft. */
  private Optional<Double> hardness() {
    return top("SmoothTransitionSettings")
        .map(each -> each.text("transitionHardness").equals("HARD") ? 0.0 : 1.0);
  }

  /** What outputs do when a program ends stood in rows of its own. */
  private void actionsOfOlderFiles() {
    List<String> kept = Rows.words(Optional.of(root), "preserveSignalAtProgramStop");
    List<String> high = Rows.words(Optional.of(root), "ProgramStateMode");
    if (kept.contains("false") || high.contains("true")) {
      remarks.add(text("oldActions"));
    }
    understood.addAll(List.of("preserveSignalAtProgramStop", "ProgramStateMode", "setSignalLow"));
  }

  private Optional<Joints> home() {
    Optional<XmlElement> home = top("SafeHomeSettings");
    double[] position =
        Rows.numbers(home.map(each -> each.text("position")).orElse(""), Joints.COUNT);
    return position.length == 0 ? Optional.empty() : Optional.of(Joints.of(position));
  }

  private static boolean isOff(XmlElement element) {
    return element.text("enabled").equals("false") || element.text("autoLoad").equals("false");
  }

  private void tellTheRest() {
    String rest =
        root.children().stream()
            .filter(each -> !understood.contains(each.name()))
            .filter(each -> !isOff(each))
            .map(XmlElement::name)
            .distinct()
            .collect(Collectors.joining(", "));
    if (!rest.isEmpty()) {
      remarks.add(text("restUnknown", rest));
    }
  }
}
