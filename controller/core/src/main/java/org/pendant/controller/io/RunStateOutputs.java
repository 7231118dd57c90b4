package org.pendant.controller.io;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;

/**
 * Outputs that follow what the program does (manual 19.6 to 19.10). An action holds, also after the
 * program that chose it, until another one is chosen. A program that is paused does not run.
 *
 * <p>A program ends unexpectedly by a protective stop, a fault, a violation or an error in it;
 * being paused by one of them counts as well.
 */
public final class RunStateOutputs {
  private final DigitalIo digital;
  private final AnalogIo analog;
  private final RegisterIo registers;
  private final RunStateAction[] standard = preserved(SignalBank.STANDARD_OUT.size());
  private final RunStateAction[] configurable = preserved(SignalBank.CONFIGURABLE_OUT.size());
  private final RunStateAction[] tool = preserved(SignalBank.TOOL_OUT.size());
  private final RunStateAction[] analogOut = preserved(AnalogBank.SIZE);
  private final RunStateAction[] booleans = preserved(RegisterKind.BOOLEAN.size());
  private final List<Consumer<Function<RunStateAction, Optional<Boolean>>>> others =
      new ArrayList<>();
  private boolean running;
  private boolean stoppedUnscheduled;
  private boolean powered;

  RunStateOutputs(DigitalIo digital, AnalogIo analog, RegisterIo registers) {
    this.digital = digital;
    this.analog = analog;
    this.registers = registers;
  }

  private static RunStateAction[] preserved(int count) {
    RunStateAction[] actions = new RunStateAction[count];
    Arrays.fill(actions, RunStateAction.PRESERVE);
    return actions;
  }

  /** Something happens that outputs may follow. */
  private enum Event {
    STARTED,
    RESUMED,
    HELD,
    HELD_UNSCHEDULED,
    POWER
  }

  /**
   * Chooses what a digital output does; it does so at once where that says something about now.
   *
   * @throws IllegalArgumentException if {@code output} is no output
   */
  public void choose(Signal output, RunStateAction action) {
    switch (output.bank()) {
      case STANDARD_OUT -> standard[output.index()] = action;
      case CONFIGURABLE_OUT -> configurable[output.index()] = action;
      case TOOL_OUT -> tool[output.index()] = action;
      case STANDARD_IN, CONFIGURABLE_IN, TOOL_IN, FLAG ->
          throw new IllegalArgumentException(output + " is no output");
    }
    now(action).ifPresent(level -> digital.set(output.bank(), output.index(), level));
  }

  /** Chooses what an analog output does; high is the high end of its range. */
  public void chooseAnalog(int index, RunStateAction action) {
    AnalogBank.STANDARD_OUT.check(index);
    analogOut[index] = action;
    now(action).ifPresent(level -> analog.setOutput(index, level ? 1 : 0));
  }

  /** Chooses what a boolean output register does, 0 to 127. */
  public void chooseRegister(int address, RunStateAction action) {
    RegisterKind.BOOLEAN.check(address);
    booleans[address] = action;
    now(action).ifPresent(level -> registers.setBool(address, level));
  }

  /**
   * Has outputs elsewhere follow as well.
   *
   * @param outputs told, whenever something happens, which level each action asks for
   */
  public void lead(Consumer<Function<RunStateAction, Optional<Boolean>>> outputs) {
    others.add(outputs);
  }

  /** The level that an action which is chosen now asks for at once; none where it asks for none. */
  public Optional<Boolean> now(RunStateAction action) {
    if (action == RunStateAction.HIGH_WITH_POWER || action == RunStateAction.LOW_WITH_POWER) {
      return level(action, Event.POWER);
    }
    return level(action, running ? Event.STARTED : Event.HELD);
  }

  /** A program starts, or continues after a pause. */
  public void started(boolean resumed) {
    running = true;
    apply(resumed && !stoppedUnscheduled ? Event.RESUMED : Event.STARTED);
    stoppedUnscheduled = false;
  }

  /**
   * The program ends or is paused.
   *
   * @param unscheduled whether something unexpected is the cause
   */
  public void held(boolean unscheduled) {
    running = false;
    stoppedUnscheduled = unscheduled;
    apply(unscheduled ? Event.HELD_UNSCHEDULED : Event.HELD);
  }

  /** Tells in each frame whether the arm has power. */
  public void power(boolean on) {
    if (on != powered) {
      powered = on;
      apply(Event.POWER);
    }
  }

  private void apply(Event event) {
    apply(event, SignalBank.STANDARD_OUT, standard);
    apply(event, SignalBank.CONFIGURABLE_OUT, configurable);
    apply(event, SignalBank.TOOL_OUT, tool);
    for (int i = 0; i < analogOut.length; i++) {
      int index = i;
      level(analogOut[i], event).ifPresent(level -> analog.setOutput(index, level ? 1 : 0));
    }
    for (int i = 0; i < booleans.length; i++) {
      int address = i;
      level(booleans[i], event).ifPresent(level -> registers.setBool(address, level));
    }
    others.forEach(each -> each.accept(action -> level(action, event)));
  }

  private void apply(Event event, SignalBank bank, RunStateAction[] actions) {
    for (int i = 0; i < actions.length; i++) {
      int index = i;
      level(actions[i], event).ifPresent(level -> digital.set(bank, index, level));
    }
  }

  /** The level that an action asks for; none where it says nothing about the event. */
  private Optional<Boolean> level(RunStateAction action, Event event) {
    boolean held = event == Event.HELD || event == Event.HELD_UNSCHEDULED;
    return switch (action) {
      case PRESERVE -> Optional.empty();
      case LOW_WHEN_NOT_RUNNING -> held ? Optional.of(false) : Optional.empty();
      case HIGH_WHEN_NOT_RUNNING -> held ? Optional.of(true) : Optional.empty();
      case HIGH_WHEN_RUNNING -> event == Event.POWER ? Optional.empty() : Optional.of(!held);
      case LOW_ON_UNSCHEDULED_STOP ->
          event == Event.HELD_UNSCHEDULED ? Optional.of(false) : Optional.empty();
      case HIGH_FROM_START_LOW_ON_UNSCHEDULED_STOP ->
          switch (event) {
            case STARTED -> Optional.of(true);
            case HELD_UNSCHEDULED -> Optional.of(false);
            case RESUMED, HELD, POWER -> Optional.empty();
          };
      case HIGH_WITH_POWER -> event == Event.POWER ? Optional.of(powered) : Optional.empty();
      case LOW_WITH_POWER -> event == Event.POWER ? Optional.of(!powered) : Optional.empty();
    };
  }
}
