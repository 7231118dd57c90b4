package org.pendant.controller.quantity;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.TestController;
import org.pendant.controller.command.Command;
import org.pendant.controller.io.IoCommand;
import org.pendant.controller.io.Signal;
import org.pendant.controller.io.SignalBank;
import org.pendant.controller.io.SignalWrite;
import org.pendant.controller.safety.SafetyCommand;
import org.pendant.controller.safety.SafetyInput;

class PortImageTest {
  private final Controller controller = new Controller(ControllerOptions.headless());

  private int register(int address) {
    return PortImage.register(address, controller.state()).orElseThrow();
  }

  private void send(Command command) {
    var _ = controller.submit(command);
    controller.advance();
  }

  private void start(String text) {
    send(new ProgramCommand.StartProgram(TestController.program(controller, text)));
  }

  @Test
  void readsSignalsBelow256AsThePortMapDoes() {
    send(
        new IoCommand.WriteSignals(
            new SignalWrite.Digital(new Signal(SignalBank.STANDARD_OUT, 3), true)));
    assertEquals(8, register(1));
    assertEquals(Optional.of(true), PortImage.bit(19, controller.state()));
    assertEquals(Optional.empty(), PortImage.register(12, controller.state()));
  }

  @Test
  void negativeNumbersAreTheirTwosComplement() {
    start("def turn():\n  speedj([-0.5, 0, 0, 0, 0, 0.25], 5, 10)\nend\n");
    controller.runUntil(() -> false, 500);
    double speed = controller.state().arm().actualSpeedRadPerS().q0();
    assertEquals(0x10000 + Math.round(1000 * speed), register(280));
    assertEquals(-500, (short) register(280), 2);
    assertEquals(250, register(285), 2);
    double y = controller.state().geometry().actual().speed().y();
    assertEquals(Math.round(1000 * y), (short) register(411));
  }

  @Test
  void posesAreInTenthsOfMillimetresAndMilliradians() {
    var pose = controller.state().arm().actualTcpInBase();
    assertEquals(Math.round(10_000 * pose.x()), (short) register(400));
    assertEquals(Math.round(1000 * pose.rx()), (short) register(403));
  }

  @Test
  void everyBlockHasSixRegistersAndGapsHaveNone() {
    for (int block : new int[] {270, 280, 290, 300, 310, 320, 400, 410, 420}) {
      for (int i = 0; i < 6; i++) {
        assertEquals(true, PortImage.register(block + i, controller.state()).isPresent());
      }
      assertEquals(Optional.empty(), PortImage.register(block + 6, controller.state()));
    }
    assertEquals(Optional.empty(), PortImage.register(259, controller.state()));
    assertEquals(Optional.empty(), PortImage.register(65_535, controller.state()));
    assertEquals(Optional.empty(), PortImage.register(-1, controller.state()));
    assertEquals(Optional.empty(), PortImage.bit(266, controller.state()));
  }

  @Test
  void stopsShowInBitsAndRegisters() {
    send(new SafetyCommand.SetSafetyInput(SafetyInput.EMERGENCY_STOP, true));
    assertEquals(1, register(262));
    assertEquals(1, register(265));
    assertEquals(0, register(261));
    assertEquals(Optional.of(true), PortImage.bit(262, controller.state()));
    assertEquals(Optional.of(false), PortImage.bit(264, controller.state()));
  }

  @Test
  void temperaturesAndCurrentsAreInWholeUnitsAndThousandths() {
    controller.advance();
    assertEquals(25, register(300));
    assertEquals(80, register(770));
    assertEquals(Math.round(1000 * controller.state().readings().robotCurrentA()), register(450));
    assertEquals(true, register(450) >= 500);
    assertEquals(253, register(310));
  }
}
