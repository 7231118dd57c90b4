package org.pendant.controller.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;
import org.pendant.controller.command.Refusal;
import org.pendant.controller.external.ToolCommunication;

class SignalsTest {
  private final Signals signals = new Signals();

  private static String refusal(Executable write) {
    return assertThrows(IllegalArgumentException.class, write).getMessage();
  }

  @Test
  void theStateStaysTheSameObjectWhileNothingChanges() {
    signals.write(new SignalWrite.ToolVoltage(24));
    signals.write(new SignalWrite.PortRegister(128, (short) 7));
    SignalState state = signals.state();
    signals.write(new SignalWrite.ToolVoltage(24));
    signals.write(new SignalWrite.PortRegister(128, (short) 7));
    signals.write(new SignalWrite.PortBit(128, false));
    signals.setRegisterAction(3, InputAction.DEFAULT);
    assertSame(state, signals.state());
    signals.write(new SignalWrite.BooleanRegister(RegisterDirection.INPUT, 64, true));
    assertTrue(signals.state().registers(RegisterDirection.INPUT).bool(64));
    assertFalse(signals.state().registers(RegisterDirection.OUTPUT).bool(64));
    assertFalse(state.inputs().bool(64));
  }

  @Test
  void theToolConnectorIsSetUpPieceByPiece() {
    signals.write(new SignalWrite.ToolVoltage(12));
    signals.write(new SignalWrite.ToolOutputs(ToolOutputMode.DUAL_PIN_POWER));
    signals.write(new SignalWrite.ToolPin(0, ToolPinMode.SOURCING));
    signals.write(new SignalWrite.ToolPin(1, ToolPinMode.PUSH_PULL));
    assertEquals(
        new ToolConnector(
            12,
            ToolOutputMode.DUAL_PIN_POWER,
            ToolPinMode.SOURCING,
            ToolPinMode.PUSH_PULL,
            ToolCommunication.STANDARD),
        signals.state().tool());
  }

  @Test
  void aHighInputAsksForFreedriveOnlyWithThatAction() {
    signals.digital().set(SignalBank.TOOL_IN, 1, true);
    assertFalse(signals.freedriveDemanded());
    signals.setAction(new Signal(SignalBank.TOOL_IN, 1), InputAction.FREEDRIVE);
    assertTrue(signals.freedriveDemanded());
    signals.digital().set(SignalBank.TOOL_IN, 1, false);
    assertFalse(signals.freedriveDemanded());
  }

  @Test
  void aTrueRegisterAsksForFreedriveWithThatAction() {
    for (int address : new int[] {0, 63, 64, 127}) {
      signals.setRegisterAction(address, InputAction.FREEDRIVE);
      assertEquals(InputAction.FREEDRIVE, signals.actions().ofRegister(address));
      signals.write(new SignalWrite.BooleanRegister(RegisterDirection.INPUT, address, true));
      assertTrue(signals.freedriveDemanded());
      signals.clearActions();
      assertFalse(signals.freedriveDemanded());
    }
  }

  @Test
  void actionsAreOfOneInputEach() {
    signals.setAction(new Signal(SignalBank.STANDARD_IN, 2), InputAction.FREEDRIVE);
    signals.setAction(new Signal(SignalBank.CONFIGURABLE_IN, 3), InputAction.FREEDRIVE);
    signals.setAction(new Signal(SignalBank.STANDARD_IN, 2), InputAction.DEFAULT);
    assertEquals(new InputActions(0, 8, 0, 0, 0), signals.state().actions());
    assertEquals(
        InputAction.FREEDRIVE, signals.actions().of(new Signal(SignalBank.CONFIGURABLE_IN, 3)));
  }

  @Test
  void valuesThatASignalCannotHaveAreRefused() {
    assertEquals(
        "analog_in[0] is 11.0 V, must be 0.0 to 10.0 V",
        refusal(
            () ->
                new SignalWrite.AnalogInput(AnalogBank.STANDARD_IN, 0, 11, AnalogDomain.VOLTAGE)));
    assertEquals(
        "tool_analog_in[1] is 0.003 A, must be 0.004 to 0.02 A",
        refusal(
            () -> new SignalWrite.AnalogInput(AnalogBank.TOOL_IN, 1, 0.003, AnalogDomain.CURRENT)));
    assertEquals(
        "analog_out[0] is no input",
        refusal(
            () ->
                new SignalWrite.AnalogInput(AnalogBank.STANDARD_OUT, 0, 1, AnalogDomain.VOLTAGE)));
    assertEquals(
        "analog_out[1] is NaN, must be 0 to 1",
        refusal(() -> new SignalWrite.AnalogOutput(1, Double.NaN)));
    assertEquals(
        "tool voltage is 13 V, must be 0, 12 or 24 V",
        refusal(() -> new SignalWrite.ToolVoltage(13)));
    assertEquals(
        "port: address is 127, must be 128 to 255",
        refusal(() -> new SignalWrite.PortBit(127, true)));
  }

  @Test
  void aSignalThatIsTakenRefusesOtherWriters() {
    InputOwners owners = signals.owners();
    String register = RegisterDirection.INPUT.name(RegisterKind.INTEGER, 24);
    assertEquals(Optional.empty(), owners.claim(register, "RTDE client 1"));
    assertEquals(Optional.empty(), owners.claim(register, "RTDE client 1"));
    assertEquals(
        Optional.of("input_integer_register[24] is in use by RTDE client 1"),
        owners.claim(register, "RTDE client 2").map(Refusal::text));
    assertEquals(Optional.empty(), owners.refusal(register, "RTDE client 1"));
    assertTrue(owners.refusal(register, InputOwners.BY_HAND).isPresent());
    owners.release("RTDE client 2");
    assertEquals(Optional.of("RTDE client 1"), owners.owner(register));
    owners.release("RTDE client 1");
    assertEquals(Optional.empty(), owners.owner(register));
  }
}
