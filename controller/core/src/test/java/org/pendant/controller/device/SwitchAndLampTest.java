package org.pendant.controller.device;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.RunningProgram;
import org.pendant.controller.box.EquipmentReader;
import org.pendant.controller.box.WorldCommand;
import org.pendant.controller.state.RobotBits;
import org.pendant.controller.world.SceneReader;

/** Limit switches, buttons and lamps. */
class SwitchAndLampTest {
  private static final String START =
      "{'devices': [{'type': 'button', 'name': 'start', 'signal': 'digital_in[0]',"
          + " 'min': [2, 2, 0], 'max': [2.1, 2.1, 0.1]%s}]%s}";

  private static RunningProgram cell(String scene) throws Exception {
    byte[] text = scene.replace('\'', '"').getBytes(StandardCharsets.UTF_8);
    return new RunningProgram(
        ControllerOptions.headless()
            .withScene(SceneReader.read("cell.json", new ByteArrayInputStream(text)))
            .withEquipment(EquipmentReader.read("cell.json", new ByteArrayInputStream(text))));
  }

  private static boolean input(RunningProgram program) {
    return (RobotBits.digitalInputs(program.state().io()) & 1) != 0;
  }

  @Test
  void aLimitSwitchIsPressedWhileABodyTouchesIt() throws Exception {
    RunningProgram program =
        cell(
            "{'devices': [{'type': 'limit-switch', 'signal': 'digital_in[0]', 'min': [0.4, 0.9,"
                + " 0.38], 'max': [0.6, 1.1, 0.42]}], 'objects': [{'type': 'sphere', 'name':"
                + " 'ball', 'centre': [0.5, 1, 1], 'radius': 0.04, 'mass': 0.5}]}");
    int pressed = 0;
    for (int frame = 0; frame < 300; frame++) {
      program.advance(1);
      pressed += input(program) ? 1 : 0;
    }
    // it falls 0.12 m at 3.4 m/s
    assertEquals(18, pressed, 2);
    assertFalse(input(program));
  }

  @Test
  void aButtonIsPressedByHandUntilItIsLetGo() throws Exception {
    RunningProgram program = cell(START.formatted("", ""));
    program.advance(2);
    assertFalse(input(program));
    program.done(new WorldCommand.PutPart("start", 1));
    program.advance(2);
    assertTrue(input(program));
    assertTrue(program.state().devices().getFirst().on());
    program.done(new WorldCommand.PutPart("start", 0));
    program.advance(2);
    assertFalse(input(program));
  }

  @Test
  void aRulePressesAButtonForATime() throws Exception {
    RunningProgram program =
        cell(
            START.formatted(
                "",
                ", 'rules': [{'when': 'digital_out[0] rises', 'after': 0.2, 'press': 'start',"
                    + " 'for': 0.1}]"));
    program.start("def f():\n  set_standard_digital_out(0, True)\n  sleep(1)\nend\n");
    int pressed = 0;
    int first = 0;
    for (int frame = 1; frame < 300; frame++) {
      program.advance(1);
      if (input(program)) {
        pressed++;
        first = first == 0 ? frame : first;
      }
    }
    assertEquals(50, pressed);
    assertEquals(100, first, 5);
  }

  @Test
  void anInvertedButtonIsHighWhileNothingPressesIt() throws Exception {
    RunningProgram program = cell(START.formatted(", 'inverted': true", ""));
    program.advance(2);
    assertTrue(input(program));
    assertFalse(program.state().devices().getFirst().on());
  }

  @Test
  void aLampShowsAnOutput() throws Exception {
    RunningProgram program =
        cell("{'devices': [{'type': 'lamp', 'name': 'red', 'signal': 'digital_out[1]'}]}");
    program.advance(2);
    assertFalse(program.state().devices().getFirst().on());
    program.run("def f():\n  set_standard_digital_out(1, True)\n  sleep(0.1)\nend\n");
    assertTrue(program.state().devices().getFirst().on());
  }
}
