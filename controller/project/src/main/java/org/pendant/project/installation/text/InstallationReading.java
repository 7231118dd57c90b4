package org.pendant.project.installation.text;

import static org.pendant.project.installation.text.InstallationLineTexts.text;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.pendant.controller.box.Inertia;
import org.pendant.controller.external.ModbusKind;
import org.pendant.controller.external.ToolCommunication;
import org.pendant.controller.installation.BaseMounting;
import org.pendant.controller.installation.ControlHost;
import org.pendant.controller.installation.ConveyorSetup;
import org.pendant.controller.installation.Feature;
import org.pendant.controller.installation.FeatureKind;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.installation.InstallationVariable;
import org.pendant.controller.installation.ModbusSetup;
import org.pendant.controller.installation.NamedPayload;
import org.pendant.controller.installation.NamedTool;
import org.pendant.controller.installation.SignalUse;
import org.pendant.controller.installation.StartUp;
import org.pendant.controller.installation.Wiring;
import org.pendant.controller.io.AnalogDomain;
import org.pendant.controller.io.InputAction;
import org.pendant.controller.io.RunStateAction;
import org.pendant.controller.io.ToolOutputMode;
import org.pendant.controller.io.ToolPinMode;
import org.pendant.controller.io.WatchdogAction;
import org.pendant.controller.safety.SafetyConfiguration;
import org.pendant.controller.world.Vector3;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.project.program.text.LineText;
import org.pendant.project.program.text.TextProblem;
import org.pendant.project.program.text.WrongText;

/** Installation parser: reads a text once, line by line, and continues after what is wrong. */
final class InstallationReading {
  /** Far above any real one; a longer text is something else. */
  private static final int LONGEST = 4 << 20;

  private static final int MAX_PROBLEMS = 100;
  private static final String INDENT = "  ";

  /** Lines of which there may be several. */
  private static final Set<String> REPEATED =
      Set.of("tool", "payload", "signal", "feature", "variable", "conveyor", "modbus");

  private static final String WORDS =
      "robot, tool, active-tool, payload, active-payload, mounting, signal, analog,"
          + " tool-connector, tool-communication, feature, home, variable, start-up, conveyor,"
          + " modbus, ethernet-ip, external-control, transition, safety";

  private final List<TextProblem> problems = new ArrayList<>();
  private final Map<String, Integer> firstLines = new HashMap<>();

  private String robot = "";
  private String calibration = "";
  private final List<NamedTool> tools = new ArrayList<>();
  private String activeTool = "";
  private final List<NamedPayload> payloads = new ArrayList<>();
  private String activePayload = "";
  private BaseMounting mounting = BaseMounting.FLOOR;
  private final List<SignalUse> signals = new ArrayList<>();
  private Wiring wiring = Wiring.STANDARD;
  private final List<Feature> features = new ArrayList<>();
  private Joints homeRad = Installation.NONE.homeRad();
  private final List<InstallationVariable> variables = new ArrayList<>();
  private StartUp startUp = StartUp.NOTHING;
  private Optional<SafetyLines> safetyLines = Optional.empty();
  private Optional<SafetyConfiguration> safety = Optional.empty();
  private final List<ConveyorSetup> conveyors = new ArrayList<>();
  private final List<ModbusSetup> modbus = new ArrayList<>();
  private Optional<WatchdogAction> ethernetIpLoss = Optional.empty();
  private ControlHost controlHost = ControlHost.STANDARD;
  private double transitionHardness = Installation.NONE.transitionHardness();

  /** What stands for a line that could not be read: what is below it is not looked at either. */
  private static final String BROKEN = "?";

  /** The line at the left edge that indented ones belong to; empty before the first. */
  private String above = "";

  InstallationReading(String text) {
    if (text.length() > LONGEST) {
      complain(1, 1, text("tooLong", text.length(), LONGEST));
      return;
    }
    List<String> lines = text.lines().toList();
    String first = lines.isEmpty() ? "" : lines.getFirst().stripTrailing();
    if (!first.equals(InstallationText.HEADING)) {
      complain(1, 1, text("firstLine", InstallationText.HEADING));
    }
    for (int i = 1; i < lines.size(); i++) {
      line(i + 1, lines.get(i));
    }
    finishSafety();
  }

  Installation installation() {
    return new Installation(
        robot,
        calibration,
        tools,
        activeTool,
        payloads,
        activePayload,
        mounting,
        signals,
        wiring,
        features,
        homeRad,
        variables,
        startUp,
        safety,
        conveyors,
        modbus,
        ethernetIpLoss,
        transitionHardness,
        controlHost);
  }

  List<TextProblem> problems() {
    problems.sort(Comparator.comparingInt(TextProblem::line));
    return problems;
  }

  private void complain(int line, int column, String message) {
    if (problems.size() < MAX_PROBLEMS) {
      problems.add(new TextProblem(line, column, message));
    }
  }

  private void line(int number, String line) {
    String content = line.strip();
    if (content.isEmpty()) {
      return;
    }
    try {
      if (content.startsWith("#")) {
        throw new WrongText(1 + line.indexOf('#'), text("remark"));
      }
      if (line.startsWith(INDENT) && line.charAt(INDENT.length()) != ' ') {
        below(LineText.parse(content, 1 + INDENT.length()));
      } else if (line.startsWith(" ") || line.startsWith("\t")) {
        throw new WrongText(1, text("indented"));
      } else {
        above = BROKEN;
        top(number, LineText.parse(content, 1));
      }
    } catch (WrongText e) {
      complain(number, e.column(), e.getMessage());
    } catch (IllegalArgumentException e) {
      complain(number, 1, e.getMessage());
    }
  }

  /** A line that belongs to the one above it. */
  private void below(LineText line) throws WrongText {
    LineFields fields = new LineFields(line, 1 + INDENT.length());
    switch (above) {
      case "feature" -> {
        if (!line.word().equals("point")) {
          throw fields.wrong(text("belowFeature"));
        }
        Feature feature = features.getLast();
        List<Pose> points = new ArrayList<>(feature.points());
        points.add(fields.pose("pose"));
        fields.requireAllKnown();
        if (points.size() > feature.kind().points()) {
          throw fields.wrong(
              text("tooManyPoints", Words.of(feature.kind()), feature.kind().points()));
        }
        features.set(
            features.size() - 1,
            new Feature(
                feature.name(), feature.kind(), points, feature.variable(), feature.joggable()));
      }
      case SafetyLines.HEADING -> {
        safetyLines.orElseThrow().read(line.word(), fields);
        fields.requireAllKnown();
      }
      case BROKEN -> {}
      default -> throw fields.wrong(text("belowNothing"));
    }
  }

  private void top(int number, LineText line) throws WrongText {
    LineFields fields = new LineFields(line, 1);
    Integer before = firstLines.putIfAbsent(line.word(), number);
    if (before != null && !REPEATED.contains(line.word())) {
      throw fields.wrong(text("saidAlready", before));
    }
    switch (line.word()) {
      case "robot" -> {
        robot = fields.text("id");
        calibration = fields.textIfAny("calibration");
      }
      case "tool" -> tools.add(new NamedTool(fields.text("name"), fields.pose("in-flange")));
      case "active-tool" -> activeTool = fields.text("name");
      case "payload" -> payloads.add(payload(fields));
      case "active-payload" -> activePayload = fields.text("name");
      case "mounting" ->
          mounting = new BaseMounting(fields.number("tilt-rad"), fields.number("rotation-rad"));
      case "signal" -> signals.add(signal(fields));
      case "analog" -> wiring = analog(fields);
      case "tool-connector" -> wiring = connector(fields);
      case "tool-communication" -> wiring = communication(fields);
      case "feature" -> features.add(feature(fields));
      case "home" -> homeRad = fields.joints("joints-rad");
      case "variable" -> variables.add(variable(fields));
      case "start-up" -> startUp = startUp(fields);
      case "conveyor" -> conveyors.add(conveyor(fields));
      case "modbus" -> modbus.add(modbus(fields));
      case "ethernet-ip" ->
          ethernetIpLoss = Optional.of(fields.constant("on-loss", WatchdogAction.class));
      case "external-control" ->
          controlHost = new ControlHost(fields.text("host"), fields.whole("port"));
      case "transition" -> transitionHardness = fields.number("hardness");
      case SafetyLines.HEADING -> safetyLines = Optional.of(new SafetyLines());
      default -> throw new WrongText(1, text("unknownLine", line.word(), WORDS));
    }
    fields.requireAllKnown();
    above = line.word();
  }

  private static NamedPayload payload(LineFields fields) throws WrongText {
    double[] cog = fields.numbers("cog-m", 3);
    return new NamedPayload(
        fields.text("name"),
        fields.number("mass-kg"),
        new Vector3(cog[0], cog[1], cog[2]),
        Inertia.of(fields.numbers("inertia-kg-m2", 6)));
  }

  private static SignalUse signal(LineFields fields) throws WrongText {
    return new SignalUse(
        fields.text("id"),
        fields.textIfAny("name"),
        fields.constant("input", InputAction.class, InputAction.DEFAULT),
        fields.constant("output", RunStateAction.class, RunStateAction.PRESERVE));
  }

  private Wiring analog(LineFields fields) throws WrongText {
    return new Wiring(
        fields.constants("in", AnalogDomain.class, 2),
        fields.constants("out", AnalogDomain.class, 2),
        fields.constants("tool-in", AnalogDomain.class, 2),
        wiring.toolVoltage(),
        wiring.toolOutputMode(),
        wiring.toolPins(),
        wiring.toolCommunication());
  }

  private Wiring connector(LineFields fields) throws WrongText {
    return new Wiring(
        wiring.analogIn(),
        wiring.analogOut(),
        wiring.toolAnalogIn(),
        fields.whole("voltage-v"),
        fields.constant("outputs", ToolOutputMode.class),
        fields.constants("pins", ToolPinMode.class, 2),
        wiring.toolCommunication());
  }

  private Wiring communication(LineFields fields) throws WrongText {
    return new Wiring(
        wiring.analogIn(),
        wiring.analogOut(),
        wiring.toolAnalogIn(),
        wiring.toolVoltage(),
        wiring.toolOutputMode(),
        wiring.toolPins(),
        new ToolCommunication(
            fields.flag("enabled"),
            fields.whole("baud-rate"),
            fields.constant("parity", ToolCommunication.Parity.class),
            fields.whole("stop-bits"),
            fields.small("rx-idle-chars"),
            fields.small("tx-idle-chars")));
  }

  private static Feature feature(LineFields fields) throws WrongText {
    return new Feature(
        fields.text("name"),
        fields.constant("kind", FeatureKind.class),
        List.of(),
        fields.flag("variable"),
        fields.flag("joggable"));
  }

  private static InstallationVariable variable(LineFields fields) throws WrongText {
    return new InstallationVariable(
        fields.text("name"), fields.text("value"), fields.flag("favourite"));
  }

  private static StartUp startUp(LineFields fields) throws WrongText {
    return new StartUp(
        fields.textIfAny("program"),
        fields.textIfAny("start-input"),
        fields.oneOf("start-on", "high", "low", true),
        fields.textIfAny("power-input"),
        fields.oneOf("power-on", "high", "low", true));
  }

  private static ConveyorSetup conveyor(LineFields fields) throws WrongText {
    return new ConveyorSetup(
        fields.whole("number"),
        fields.whole("encoder"),
        fields.textIfAny("feature"),
        fields.flag("circular"),
        fields.number("ticks-per-unit"),
        fields.flag("rotate-tool"),
        fields.whole("decoder"),
        fields.wholes("inputs"));
  }

  private static ModbusSetup modbus(LineFields fields) throws WrongText {
    return new ModbusSetup(
        fields.text("name"),
        fields.text("device"),
        fields.whole("unit"),
        fields.constant("kind", ModbusKind.class),
        fields.whole("address"),
        fields.whole("update-hz"));
  }

  private void finishSafety() {
    if (safetyLines.isEmpty()) {
      return;
    }
    try {
      safety = Optional.of(safetyLines.get().configuration());
    } catch (IllegalArgumentException e) {
      complain(firstLines.get(SafetyLines.HEADING), 1, SafetyLines.HEADING + ": " + e.getMessage());
    }
  }
}
