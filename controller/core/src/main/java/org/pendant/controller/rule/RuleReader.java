package org.pendant.controller.rule;

import static org.pendant.controller.rule.RuleTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.pendant.controller.rule.RuleSetup.Action;
import org.pendant.controller.rule.RuleSetup.Trigger;
import org.pendant.controller.wire.CellSignal;
import org.pendant.controller.wire.CellSignalNames;
import org.pendant.controller.wire.SignalGroup;
import org.pendant.language.check.Nearest;
import org.pendant.models.json.Json;
import org.pendant.models.json.JsonException;
import org.pendant.models.json.JsonFields;
import org.pendant.models.json.Range;

/** Rule reader: reads the rules of a cell; docs/devices.md describes them. */
public final class RuleReader {
  /** Rules of a cell at most. */
  public static final int MAX_RULES = 256;

  private final CellSignalNames signals;
  private final Map<String, Double> grippers;
  private final List<String> switches;

  private RuleReader(CellSignalNames signals, Map<String, Double> grippers, List<String> switches) {
    this.signals = signals;
    this.grippers = grippers;
    this.switches = switches;
  }

  /**
   * Reads the section {@code rules}.
   *
   * @param signals what rules may look at and set
   * @param grippers how far each gripper opens, m, by its name
   * @param switches names of limit switches and buttons
   * @throws JsonException for the first thing that is wrong, with its place
   */
  public static List<RuleSetup> read(
      JsonFields scene,
      CellSignalNames signals,
      Map<String, Double> grippers,
      List<String> switches)
      throws JsonException {
    RuleReader reader = new RuleReader(signals, grippers, switches);
    List<RuleSetup> rules = new ArrayList<>();
    for (Json each : scene.array("rules", MAX_RULES)) {
      rules.add(reader.rule(new JsonFields(each, text("rule"))));
    }
    return rules;
  }

  private RuleSetup rule(JsonFields fields) throws JsonException {
    fields.allow(
        Nearest::among,
        "when",
        "while",
        "every",
        "after",
        "for",
        "set",
        "to",
        "part",
        "width",
        "press");
    Trigger trigger = trigger(fields);
    double forS = fields.number("for", RuleSetup.TIME, 0);
    if (forS > 0 && trigger instanceof Trigger.While) {
      throw fields.required("for").place().refusal(text("forWithWhile"));
    }
    return new RuleSetup(trigger, fields.number("after", RuleSetup.TIME, 0), action(fields), forS);
  }

  private Trigger trigger(JsonFields fields) throws JsonException {
    one(fields, "when", "while", "every");
    if (fields.optional("every").isPresent()) {
      return new Trigger.Every(fields.number("every", RuleSetup.PERIOD));
    }
    return fields.optional("when").isPresent()
        ? new Trigger.When(condition(fields, "when"))
        : new Trigger.While(condition(fields, "while"));
  }

  private static void one(JsonFields fields, String... keys) throws JsonException {
    long there = List.of(keys).stream().filter(each -> fields.optional(each).isPresent()).count();
    if (there != 1) {
      throw fields.place().refusal(text("oneOf", there, String.join(", ", keys)));
    }
  }

  private SignalCondition condition(JsonFields fields, String key) throws JsonException {
    Json.Text text = fields.text(key);
    try {
      return SignalCondition.of(text.value(), signals);
    } catch (IllegalArgumentException e) {
      throw text.place().refusal(key + ": " + e.getMessage());
    }
  }

  private Action action(JsonFields fields) throws JsonException {
    one(fields, "set", "part", "press");
    if (fields.optional("set").isPresent()) {
      return set(fields);
    }
    if (fields.optional("press").isPresent()) {
      return press(fields.text("press"));
    }
    Json.Text name = fields.text("part");
    Double strokeM = grippers.get(name.value());
    if (strokeM == null) {
      throw name.place()
          .refusal(
              grippers.isEmpty()
                  ? text("noGripper", name.described())
                  : text("otherGripper", name.described(), String.join(", ", grippers.keySet())));
    }
    return new Action.PutPart(name.value(), fields.number("width", new Range(0, strokeM, "m")));
  }

  private Action set(JsonFields fields) throws JsonException {
    CellSignal signal = signals.settable(fields, "set");
    SignalGroup group = signals.group(signal);
    if (group.digital()) {
      boolean level = fields.optional("to").isEmpty() || fields.flag("to");
      return new Action.Set(signal, level ? 1 : 0, level ? 0 : 1);
    }
    double value = fields.number("to", group.range());
    if (value != Math.rint(value)) {
      throw fields.required("to").place().refusal(text("whole", Range.number(value)));
    }
    return new Action.Set(signal, (int) value, 0);
  }

  private Action press(Json.Text name) throws JsonException {
    if (!switches.contains(name.value())) {
      throw name.place()
          .refusal(
              switches.isEmpty()
                  ? text("noSwitch", name.described())
                  : text("otherSwitch", name.described(), String.join(", ", switches)));
    }
    return new Action.Press(name.value());
  }
}
