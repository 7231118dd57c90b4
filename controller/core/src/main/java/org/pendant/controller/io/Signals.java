package org.pendant.controller.io;

import java.util.Objects;
import org.pendant.controller.external.ToolCommunication;

/** Signals of a control box; the frame loop owns them. */
public final class Signals {
  private final DigitalIo digital = new DigitalIo();
  private final AnalogIo analog = new AnalogIo();
  private final RegisterIo inputs = new RegisterIo();
  private final RegisterIo outputs = new RegisterIo();
  private final InputOwners owners = new InputOwners();
  private final RunStateOutputs runState = new RunStateOutputs(digital, analog, outputs);
  private final InputPlayer player = new InputPlayer(this);
  private ToolConnector tool = ToolConnector.STANDARD;
  private PortLevels ports = PortLevels.ZERO;
  private InputActions actions = InputActions.DEFAULT;
  private SignalState state = newState();

  /** Digital inputs, outputs and flags. */
  public DigitalIo digital() {
    return digital;
  }

  /** Analog inputs and outputs. */
  public AnalogIo analog() {
    return analog;
  }

  /** The general-purpose registers of one direction. */
  public RegisterIo registers(RegisterDirection direction) {
    return switch (direction) {
      case INPUT -> inputs;
      case OUTPUT -> outputs;
    };
  }

  /** Who alone may write a signal. */
  public InputOwners owners() {
    return owners;
  }

  /** Outputs that follow what the program does. */
  public RunStateOutputs runState() {
    return runState;
  }

  /** What changes inputs by the time since a program began. */
  public InputPlayer player() {
    return player;
  }

  /** How the connector at the tool flange is set up. */
  public ToolConnector tool() {
    return tool;
  }

  /**
   * The current that the tool takes, A.
   *
   * @param powered whether the arm has power
   */
  public double toolCurrentA(boolean powered) {
    return powered ? tool.currentA(digital.levels().toolOut()) : 0;
  }

  /** Sets up the serial line of the tool connector; while it is on, the analog inputs are off. */
  public void setToolCommunication(ToolCommunication wanted) {
    tool = tool.withCommunication(wanted);
    analog.cutOffTool(wanted.enabled());
  }

  /** What high levels of inputs do by themselves. */
  public InputActions actions() {
    return actions;
  }

  /** Gives a digital input an action. */
  public void setAction(Signal input, InputAction action) {
    actions = actions.with(input, action);
  }

  /** Gives a boolean input register an action, 0 to 127. */
  public void setRegisterAction(int address, InputAction action) {
    actions = actions.withRegister(address, action);
  }

  /** Takes all actions from all inputs. */
  public void clearActions() {
    actions = InputActions.DEFAULT;
  }

  /** Whether an input with that action is high and so asks for freedrive. */
  public boolean freedriveDemanded() {
    return actions.freedriveDemanded(digital.levels(), inputs.levels());
  }

  /** Carries out a change, whichever client asks for it. */
  public void write(SignalWrite change) {
    switch (change) {
      case SignalWrite.Digital set ->
          digital.set(set.signal().bank(), set.signal().index(), set.level());
      case SignalWrite.AnalogInput set ->
          analog.setInput(set.bank(), set.index(), set.value(), set.domain());
      case SignalWrite.AnalogOutput set -> analog.setOutput(set.index(), set.ratio());
      case SignalWrite.Domain set -> analog.setDomain(set.bank(), set.index(), set.domain());
      case SignalWrite.ToolVoltage set -> tool = tool.withVoltage(set.voltageV());
      case SignalWrite.ToolOutputs set -> tool = tool.withOutputMode(set.mode());
      case SignalWrite.ToolPin set -> tool = tool.withPin(set.index(), set.mode());
      case SignalWrite.BooleanRegister set ->
          registers(set.direction()).setBool(set.address(), set.value());
      case SignalWrite.IntegerRegister set ->
          registers(set.direction()).setInteger(set.address(), set.value());
      case SignalWrite.FloatRegister set ->
          registers(set.direction()).setFloating(set.address(), set.value());
      case SignalWrite.PortRegister set -> {
        if (ports.register(set.address()) != set.value()) {
          ports = ports.withRegister(set.address(), set.value());
        }
      }
      case SignalWrite.PortBit set -> {
        if (ports.bit(set.address()) != set.value()) {
          ports = ports.withBit(set.address(), set.value());
        }
      }
    }
  }

  /** All signals but the digital ones now; the same object until one changes. */
  public SignalState state() {
    if (!Objects.equals(state.analog(), analog.levels())
        || !Objects.equals(state.inputs(), inputs.levels())
        || !Objects.equals(state.outputs(), outputs.levels())
        || !Objects.equals(state.tool(), tool)
        || !Objects.equals(state.ports(), ports)
        || !Objects.equals(state.actions(), actions)) {
      state = newState();
    }
    return state;
  }

  private SignalState newState() {
    return new SignalState(
        analog.levels(), tool, inputs.levels(), outputs.levels(), ports, actions);
  }
}
