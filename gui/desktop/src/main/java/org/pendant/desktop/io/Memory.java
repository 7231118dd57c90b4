package org.pendant.desktop.io;

import static org.pendant.desktop.io.IoTexts.text;

import java.util.Optional;
import org.pendant.controller.io.RegisterDirection;
import org.pendant.controller.io.RegisterKind;
import org.pendant.controller.io.Signal;
import org.pendant.controller.io.SignalBank;
import org.pendant.controller.io.SignalWrite;
import org.pendant.controller.state.ControllerState;

/** Memory: a list of numbered places with a value each: registers of one kind, or the flags. */
sealed interface Memory {
  /** What the list is called. */
  String title();

  /** Number of places; they count from 0. */
  int size();

  /** Whether a place holds a level rather than a number. */
  boolean levels();

  /** The name of it all for components. */
  String id();

  /** What a place can hold, for people. */
  String takes();

  /** Whether a place can hold a number. */
  boolean accepts(double value);

  /** Whether the world outside writes it. */
  boolean input();

  /** The name of a place for components and settings. */
  String id(int index);

  /** The name of a place outside of scripts. */
  String name(int index);

  /** The call that reads a place in a script. */
  String inScript(int index);

  /** What a place holds, as a number; 1 for a high level. */
  double value(ControllerState state, int index);

  /** What a place is going to hold, once the controller has answered. */
  Optional<Double> asked(Forcing forcing, int index);

  /** The change that makes a place hold this; it does hold such numbers. */
  SignalWrite write(int index, double value);

  /** General-purpose registers. */
  record Registers(RegisterDirection direction, RegisterKind kind) implements Memory {
    @Override
    public String title() {
      boolean input = input();
      return switch (kind) {
        case BOOLEAN -> text(input ? "booleanInputRegisters" : "booleanOutputRegisters");
        case INTEGER -> text(input ? "integerInputRegisters" : "integerOutputRegisters");
        case FLOAT -> text(input ? "floatInputRegisters" : "floatOutputRegisters");
      };
    }

    @Override
    public String id() {
      return kind.text() + "-" + direction.text() + "-registers";
    }

    @Override
    public int size() {
      return kind.size();
    }

    @Override
    public boolean levels() {
      return kind == RegisterKind.BOOLEAN;
    }

    @Override
    public String takes() {
      return switch (kind) {
        case BOOLEAN -> text("takesLevel");
        case INTEGER -> text("takesWholeNumber");
        case FLOAT -> text("takesNumber");
      };
    }

    @Override
    public boolean accepts(double value) {
      return switch (kind) {
        case BOOLEAN -> value == 0 || value == 1;
        case INTEGER -> value == (int) value;
        case FLOAT -> Double.isFinite(value);
      };
    }

    @Override
    public boolean input() {
      return direction == RegisterDirection.INPUT;
    }

    @Override
    public String id(int index) {
      return SignalName.id(direction, kind, index);
    }

    @Override
    public String name(int index) {
      return direction.name(kind, index);
    }

    @Override
    public String inScript(int index) {
      return "read_" + direction.text() + "_" + kind.text() + "_register(" + index + ")";
    }

    @Override
    public double value(ControllerState state, int index) {
      var registers = state.signals().registers(direction);
      return switch (kind) {
        case BOOLEAN -> registers.bool(index) ? 1 : 0;
        case INTEGER -> registers.integer(index);
        case FLOAT -> registers.floating(index);
      };
    }

    @Override
    public Optional<Double> asked(Forcing forcing, int index) {
      String name = name(index);
      return switch (kind) {
        case BOOLEAN ->
            forcing
                .asked(SignalWrite.BooleanRegister.class, name)
                .map(write -> write.value() ? 1.0 : 0);
        case INTEGER ->
            forcing
                .asked(SignalWrite.IntegerRegister.class, name)
                .map(write -> (double) write.value());
        case FLOAT ->
            forcing
                .asked(SignalWrite.FloatRegister.class, name)
                .map(SignalWrite.FloatRegister::value);
      };
    }

    @Override
    public SignalWrite write(int index, double value) {
      return switch (kind) {
        case BOOLEAN -> new SignalWrite.BooleanRegister(direction, index, value != 0);
        case INTEGER -> new SignalWrite.IntegerRegister(direction, index, (int) value);
        case FLOAT -> new SignalWrite.FloatRegister(direction, index, value);
      };
    }
  }

  /** The flags. */
  record Flags() implements Memory {
    private static Signal flag(int index) {
      return new Signal(SignalBank.FLAG, index);
    }

    @Override
    public String title() {
      return text("flags");
    }

    @Override
    public int size() {
      return SignalBank.FLAG.size();
    }

    @Override
    public boolean levels() {
      return true;
    }

    @Override
    public String id() {
      return "flags";
    }

    @Override
    public String takes() {
      return text("takesLevel");
    }

    @Override
    public boolean accepts(double value) {
      return value == 0 || value == 1;
    }

    @Override
    public boolean input() {
      return false;
    }

    @Override
    public String id(int index) {
      return SignalName.id(flag(index));
    }

    @Override
    public String name(int index) {
      return flag(index).toString();
    }

    @Override
    public String inScript(int index) {
      return SignalName.inScript(flag(index));
    }

    @Override
    public double value(ControllerState state, int index) {
      return state.io().level(flag(index)) ? 1 : 0;
    }

    @Override
    public Optional<Double> asked(Forcing forcing, int index) {
      return forcing
          .asked(SignalWrite.Digital.class, name(index))
          .map(write -> write.level() ? 1.0 : 0);
    }

    @Override
    public SignalWrite write(int index, double value) {
      return new SignalWrite.Digital(flag(index), value != 0);
    }
  }
}
