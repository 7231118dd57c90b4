package org.pendant.project.installation.urp;

import static org.pendant.project.installation.urp.InstallationUrpTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.pendant.controller.safety.SafetyInput;
import org.pendant.project.installation.urp.SafetySections.Section;

/** Unmodelled safety settings: tells what settings demand that the simulated robot has not. */
final class UnmodelledSafety {
  static final String WORKPIECE = "WorkpieceConfiguration";

  /** What stands for no signal. */
  private static final String NO_SIGNAL = "255";

  private static final String FIRST = "A";
  private static final String SECOND = "B";

  /** Safety inputs of this product that demand what a signal would. */
  private static final Map<String, SafetyInput> INPUTS =
      Map.of(
          "emergencyStopInput", SafetyInput.SYSTEM_EMERGENCY_STOP,
          "reducedModeInput", SafetyInput.REDUCED_MODE,
          "automaticModeSafeguardStopInput", SafetyInput.AUTOMATIC_MODE_SAFEGUARD_STOP);

  /** A value that asks for nothing. */
  private record Idle(String section, String key, List<String> values) {}

  private static final List<Idle> IDLE =
      List.of(
          new Idle("ThreePositionEnabling", "useTP3PE", List.of("0")),
          new Idle("ThreePositionEnabling", "allowManualHighSpeed", List.of("1")),
          new Idle("ThreePositionEnabling", "safety001", List.of("0")),
          new Idle("SafetySetup", "verified", List.of("true")),
          new Idle("Profisafe", "profisafeEnabled", List.of("0")),
          new Idle("MiscConfiguration", "euromap67", List.of("0")),
          new Idle("SafetyDevices", "numberOfEnabledDevices", List.of("0")),
          new Idle("WristClamping", "normalModeWristClampingPositionEnabled", List.of("0")),
          new Idle("WristClamping", "normalModeWristClampingTorqueEnabled", List.of("0")),
          new Idle("WristClamping", "reducedModeWristClampingPositionEnabled", List.of("0")),
          new Idle("WristClamping", "reducedModeWristClampingTorqueEnabled", List.of("0")));

  /** What a simulated robot has no use for. */
  private static final Map<String, List<String>> NOT_NEEDED =
      Map.of(
          // theirs is computed in a way of its own
          "Safety Checksum",
          List.of("version", "crc"),
          "MiscConfiguration",
          List.of("teach_pendant"),
          "Profisafe",
          List.of(
              "profisafeSourceAddress", "profisafeDestinationAddress", "profisafeOperationalMode"),
          WORKPIECE,
          List.of("toolSphereIDs", "toolDirectionInclination", "toolDirectionAzimuth"));

  private final SafetySections sections;

  UnmodelledSafety(SafetySections sections) {
    this.sections = sections;
  }

  void tell() {
    for (Idle each : IDLE) {
      Section section = sections.section(each.section());
      if (section.has(each.key()) && !each.values().contains(section.text(each.key()))) {
        section.broken(each.key(), text("valueNotModelled"));
      }
    }
    NOT_NEEDED.forEach((name, keys) -> keys.forEach(sections.section(name)::text));
    home();
    toolPositions();
    signals("Inputs", "configurable_in");
    signals("Outputs", "configurable_out");
  }

  private void home() {
    Section section = sections.section("SafeHome");
    boolean set =
        SafetySections.items(section.text("safeHomePosition")).stream()
            .anyMatch(each -> !each.equals("-1.0"));
    boolean off = section.text("safeHomeEnabled").equals("0");
    if (set && !off) {
      section.remark("safeHomePosition", text("notModelled"));
    }
  }

  private void toolPositions() {
    Section section = sections.section(WORKPIECE);
    List<String> names = SafetySections.items(section.text("toolSphereNames"));
    List<String> spheres = SafetySections.items(section.text("toolSpheres"));
    for (int i = 0; i < spheres.size(); i++) {
      List<String> numbers = SafetySections.items(spheres.get(i));
      boolean off = i < names.size() && names.get(i).equals("DISABLED");
      boolean somewhere =
          numbers.stream().limit(4).anyMatch(each -> !List.of("0", "0.0", "-0.0").contains(each));
      if (somewhere && !off) {
        String name = i < names.size() ? names.get(i) : "null";
        section.remark(
            "toolSpheres",
            text(
                "toolPosition",
                name.equals("null") ? "" + i : SafetySections.shown(name),
                SafetySections.shown(spheres.get(i))));
      }
    }
  }

  /** A safety function each has two signals. */
  private void signals(String direction, String bank) {
    Section section = sections.section("SafetyIOConfiguration " + direction);
    for (String key : section.keys()) {
      String function = key.substring(0, Math.max(0, key.length() - 1));
      if (key.endsWith("_OSSD")) {
        if (!section.text(key).equals("0")) {
          section.broken(key, text("valueNotModelled"));
        }
      } else if (key.endsWith(FIRST) && section.has(function + SECOND)) {
        List<String> signals = new ArrayList<>();
        for (String each : List.of(section.text(key), section.text(function + SECOND))) {
          if (!each.equals(NO_SIGNAL)) {
            signals.add(bank + "[" + SafetySections.shown(each) + "]");
          }
        }
        if (!signals.isEmpty()) {
          tell(section, key, function, signals);
        }
      }
    }
  }

  private static void tell(Section section, String key, String function, List<String> signals) {
    SafetyInput input = INPUTS.get(function);
    String one = signals.getFirst();
    String other = signals.getLast();
    boolean single = signals.size() == 1;
    String what;
    if (input == null) {
      what =
          single
              ? text("signalNotModelled", function, one)
              : text("signalsNotModelled", function, one, other);
    } else {
      what =
          single
              ? text("signalDemanded", function, one, input.word())
              : text("signalsDemanded", function, one, other, input.word());
    }
    section.remark(key, what);
  }
}
