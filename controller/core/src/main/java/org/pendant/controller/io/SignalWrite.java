package org.pendant.controller.io;

import static org.pendant.controller.io.SignalTexts.text;

/**
 * Change to one signal, asked for from outside of programs. The constructors refuse signals and
 * values that there are not with an {@link IllegalArgumentException}.
 */
public sealed interface SignalWrite {
  /** The signal's name, the same whatever is written, such as {@code input_float_register[3]}. */
  String name();

  /** Whether the world outside sets this signal also while a program runs. */
  boolean input();

  /** The level of a digital signal. */
  record Digital(Signal signal, boolean level) implements SignalWrite {
    @Override
    public String name() {
      return signal.toString();
    }

    @Override
    public boolean input() {
      return signal.bank().input();
    }
  }

  /**
   * What is connected to an analog input; the box reads it while the input is in this domain.
   *
   * @param value A or V as the domain says, within its range
   */
  record AnalogInput(AnalogBank bank, int index, double value, AnalogDomain domain)
      implements SignalWrite {
    /** Checks signal and value. */
    public AnalogInput {
      bank.check(index);
      if (!bank.input()) {
        throw new IllegalArgumentException(bank.name(index) + " is no input");
      }
      if (!(value >= domain.low() && value <= domain.high())) {
        throw new IllegalArgumentException(
            text(
                "analogRange",
                bank.name(index),
                value,
                domain.unit(),
                domain.low(),
                domain.high(),
                domain.unit()));
      }
    }

    @Override
    public String name() {
      return bank.name(index);
    }

    @Override
    public boolean input() {
      return true;
    }
  }

  /**
   * The level of an analog output.
   *
   * @param ratio 0 for the low end of its range to 1 for the high one
   */
  record AnalogOutput(int index, double ratio) implements SignalWrite {
    /** Checks signal and value. */
    public AnalogOutput {
      AnalogBank.STANDARD_OUT.check(index);
      if (!(ratio >= 0 && ratio <= 1)) {
        throw new IllegalArgumentException(
            text("ratio", AnalogBank.STANDARD_OUT.name(index), ratio));
      }
    }

    @Override
    public String name() {
      return AnalogBank.STANDARD_OUT.name(index);
    }

    @Override
    public boolean input() {
      return false;
    }
  }

  /** What an analog signal is made of. */
  record Domain(AnalogBank bank, int index, AnalogDomain domain) implements SignalWrite {
    /** Checks the signal. */
    public Domain {
      bank.check(index);
    }

    @Override
    public String name() {
      return bank.name(index);
    }

    @Override
    public boolean input() {
      return false;
    }
  }

  /** The voltage of the tool connector: 0, 12 or 24 V. */
  record ToolVoltage(int voltageV) implements SignalWrite {
    /** The name of all of them. */
    public static final String NAME = "tool_voltage";

    /** Checks the voltage. */
    public ToolVoltage {
      if (!ToolConnector.isVoltage(voltageV)) {
        throw new IllegalArgumentException(
            "tool voltage is " + voltageV + " V, must be 0, 12 or 24 V");
      }
    }

    @Override
    public String name() {
      return NAME;
    }

    @Override
    public boolean input() {
      return false;
    }
  }

  /** What the output pins of the tool connector are for. */
  record ToolOutputs(ToolOutputMode mode) implements SignalWrite {
    /** The name of all of them. */
    public static final String NAME = "tool_output_mode";

    @Override
    public String name() {
      return NAME;
    }

    @Override
    public boolean input() {
      return false;
    }
  }

  /** How an output pin of the tool connector drives what hangs on it. */
  record ToolPin(int index, ToolPinMode mode) implements SignalWrite {
    /** Checks the pin. */
    public ToolPin {
      SignalBank.TOOL_OUT.check(index);
    }

    @Override
    public String name() {
      return "tool_digital_output_mode[" + index + "]";
    }

    @Override
    public boolean input() {
      return false;
    }
  }

  /** A boolean register, 0 to 127. */
  record BooleanRegister(RegisterDirection direction, int address, boolean value)
      implements SignalWrite {
    /** Checks the address. */
    public BooleanRegister {
      RegisterKind.BOOLEAN.check(address);
    }

    @Override
    public String name() {
      return direction.name(RegisterKind.BOOLEAN, address);
    }

    @Override
    public boolean input() {
      return direction == RegisterDirection.INPUT;
    }
  }

  /** An integer register, 0 to 47. */
  record IntegerRegister(RegisterDirection direction, int address, int value)
      implements SignalWrite {
    /** Checks the address. */
    public IntegerRegister {
      RegisterKind.INTEGER.check(address);
    }

    @Override
    public String name() {
      return direction.name(RegisterKind.INTEGER, address);
    }

    @Override
    public boolean input() {
      return direction == RegisterDirection.INPUT;
    }
  }

  /** A float register, 0 to 47. */
  record FloatRegister(RegisterDirection direction, int address, double value)
      implements SignalWrite {
    /** Checks the address. */
    public FloatRegister {
      RegisterKind.FLOAT.check(address);
    }

    @Override
    public String name() {
      return direction.name(RegisterKind.FLOAT, address);
    }

    @Override
    public boolean input() {
      return direction == RegisterDirection.INPUT;
    }
  }

  /** A register of the memory shared with Modbus clients, at 128 to 255. */
  record PortRegister(int address, short value) implements SignalWrite {
    /** Checks the address. */
    public PortRegister {
      PortLevels.check(address);
    }

    @Override
    public String name() {
      return "port_register[" + address + "]";
    }

    @Override
    public boolean input() {
      return true;
    }
  }

  /** A bit of the memory shared with Modbus clients, at 128 to 255. */
  record PortBit(int address, boolean value) implements SignalWrite {
    /** Checks the address. */
    public PortBit {
      PortLevels.check(address);
    }

    @Override
    public String name() {
      return "port_bit[" + address + "]";
    }

    @Override
    public boolean input() {
      return true;
    }
  }
}
