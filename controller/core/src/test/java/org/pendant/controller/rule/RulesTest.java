package org.pendant.controller.rule;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.pendant.controller.io.DigitalIo;
import org.pendant.controller.io.SignalBank;
import org.pendant.controller.wire.CellSignalNames;
import org.pendant.controller.wire.SignalGroup;
import org.pendant.controller.wire.SignalLine;
import org.pendant.controller.wire.SignalLines;
import org.pendant.models.json.JsonException;
import org.pendant.models.json.JsonFields;
import org.pendant.models.json.JsonFile;
import org.pendant.models.json.Range;

class RulesTest {
  private static final List<SignalGroup> PLC =
      List.of(
          new SignalGroup("coil", 0, 8, true, SignalGroup.LEVEL),
          new SignalGroup("register", 0, 4, true, new Range(0, 65_535, "")));

  private final Map<String, Integer> plc = new HashMap<>();
  private final DigitalIo io = new DigitalIo();

  private static List<RuleSetup> read(String rules) throws JsonException {
    CellSignalNames names = new CellSignalNames(SignalBank.groups());
    names.add("plc", PLC);
    String text = ("{'rules': [" + rules + "]}").replace('\'', '"');
    return RuleReader.read(
        new JsonFields(
            JsonFile.read(
                "cell.json", new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8))),
            "a scene"),
        names,
        Map.of(),
        List.of());
  }

  private Rules rules(String rules) throws JsonException {
    SignalLines lines = new SignalLines(io);
    lines.add("plc", this::line);
    return new Rules(
        read(rules),
        lines,
        new Rules.DeviceActions() {
          @Override
          public void putPart(String gripper, double widthM) {}

          @Override
          public void press(String device, boolean pressed) {}
        });
  }

  private SignalLine line(String group, int index) {
    String name = group + index;
    return new SignalLine() {
      @Override
      public int value() {
        return plc.getOrDefault(name, 0);
      }

      @Override
      public void set(int value) {
        plc.put(name, value);
      }
    };
  }

  @Test
  void signalOfAnOwnerSetsAnotherOne() throws JsonException {
    Rules rules =
        rules(
            "{'when': 'plc.coil[0] rises', 'set': 'plc.register[2]', 'to': 17},"
                + "{'while': 'plc.coil[0]', 'set': 'digital_in[3]'}");
    rules.step();
    plc.put("coil0", 1);

    rules.step();

    assertEquals(17, plc.get("register2"));
    assertTrue(io.level(SignalBank.STANDARD_IN, 3));
  }

  @ParameterizedTest
  @CsvSource({
    "is 17, 17, 1",
    "is 17, 16, 0",
    "is not 17, 16, 1",
    "is not 17, 17, 0",
    "is above 17, 18, 1",
    "is above 17, 17, 0",
    "is below 17, 16, 1",
    "is below 17, 17, 0",
    "is on, 3, 1",
    "is off, 3, 0",
  })
  void numbersAreCompared(String words, int value, int expected) throws JsonException {
    Rules rules = rules("{'while': 'plc.register[0] " + words + "', 'set': 'plc.coil[7]'}");
    plc.put("register0", value);

    rules.step();

    assertEquals(expected, plc.get("coil7"));
  }

  @Test
  void numberIsZeroAgainWhenTheTimeIsOver() throws JsonException {
    Rules rules =
        rules("{'when': 'digital_out[0]', 'set': 'plc.register[1]', 'to': 9, 'for': 0.01}");
    rules.step();
    io.set(SignalBank.STANDARD_OUT, 0, true);
    rules.step();
    assertEquals(9, plc.get("register1"));

    for (int i = 0; i < 5; i++) {
      rules.step();
    }

    assertEquals(0, plc.get("register1"));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "{'every': 1, 'set': 'plc.register[0]'} | key \"to\" is missing, a rule must have it",
        "{'every': 1, 'set': 'plc.register[0]', 'to': 70000} | to is 70000, must be 0 to 65535",
        "{'every': 1, 'set': 'plc.register[0]', 'to': 1.5} | to is 1.5, must be a whole number",
        "{'every': 1, 'set': 'plc.register[4]', 'to': 1} | set is \"plc.register[4]\", must be"
            + " plc.register[0] to [3]",
        "{'every': 1, 'set': 'digital_out[4]'} | set is \"digital_out[4]\", must be an input, such"
            + " as digital_in[0] or plc.coil[0]",
        "{'when': 'plc.register[0] is 70000', 'set': 'digital_in[0]'} | when: number is 70000, must"
            + " be 0 to 65535 for register",
        "{'when': 'plc.input[0] rises', 'set': 'digital_in[0]'} | when: signal is"
            + " \"plc.input[0]\", must be one of plc.coil[0] to [7], plc.register[0] to [3]",
      })
  void whatIsWrongIsRefused(String rule, String message) {
    String refused = assertThrows(JsonException.class, () -> read(rule)).getMessage();
    assertTrue(refused.contains(message), refused);
  }
}
