package org.pendant.recording;

import org.pendant.controller.encoder.Encoders;
import org.pendant.controller.external.ToolCommunication;
import org.pendant.controller.io.AnalogDomain;
import org.pendant.controller.io.AnalogLevels;
import org.pendant.controller.io.AnalogSignal;
import org.pendant.controller.io.DigitalLevels;
import org.pendant.controller.io.InputActions;
import org.pendant.controller.io.PortLevels;
import org.pendant.controller.io.RegisterKind;
import org.pendant.controller.io.RegisterLevels;
import org.pendant.controller.io.SignalState;
import org.pendant.controller.io.ToolConnector;
import org.pendant.controller.io.ToolOutputMode;
import org.pendant.controller.io.ToolPinMode;

/** Forms of inputs, outputs and registers. */
final class SignalForms {
  private static final int PORTS = PortLevels.LAST - PortLevels.FIRST + 1;

  static final Form<DigitalLevels> DIGITAL =
      new Form<>() {
        @Override
        void write(DigitalLevels value, ByteSink out) {
          out.whole(value.standardIn());
          out.whole(value.standardOut());
          out.whole(value.configurableIn());
          out.whole(value.configurableOut());
          out.whole(value.toolIn());
          out.whole(value.toolOut());
          out.whole(value.flags());
        }

        @Override
        DigitalLevels read(ByteSource in) throws MalformedBytes {
          return new DigitalLevels(
              in.integer(),
              in.integer(),
              in.integer(),
              in.integer(),
              in.integer(),
              in.integer(),
              in.integer());
        }
      };

  private static final Form<AnalogSignal> ANALOG_SIGNAL =
      new Form<>() {
        @Override
        void write(AnalogSignal value, ByteSink out) {
          out.number(value.value());
          out.constant(value.domain());
        }

        @Override
        AnalogSignal read(ByteSource in) throws MalformedBytes {
          return new AnalogSignal(in.number(), in.constant(AnalogDomain.class));
        }
      };

  private static final Form<AnalogLevels> ANALOG =
      new Form<>() {
        @Override
        void write(AnalogLevels value, ByteSink out) {
          ANALOG_SIGNAL.write(value.standardIn0(), out);
          ANALOG_SIGNAL.write(value.standardIn1(), out);
          ANALOG_SIGNAL.write(value.standardOut0(), out);
          ANALOG_SIGNAL.write(value.standardOut1(), out);
          ANALOG_SIGNAL.write(value.toolIn0(), out);
          ANALOG_SIGNAL.write(value.toolIn1(), out);
        }

        @Override
        AnalogLevels read(ByteSource in) throws MalformedBytes {
          return new AnalogLevels(
              ANALOG_SIGNAL.read(in),
              ANALOG_SIGNAL.read(in),
              ANALOG_SIGNAL.read(in),
              ANALOG_SIGNAL.read(in),
              ANALOG_SIGNAL.read(in),
              ANALOG_SIGNAL.read(in));
        }
      };

  private static final Form<ToolConnector> TOOL =
      new Form<>() {
        @Override
        void write(ToolConnector value, ByteSink out) {
          out.whole(value.voltageV());
          out.constant(value.outputMode());
          out.constant(value.pin0());
          out.constant(value.pin1());
          ToolCommunication line = value.communication();
          out.bool(line.enabled());
          out.whole(line.baudRate());
          out.constant(line.parity());
          out.whole(line.stopBits());
          out.number(line.rxIdleChars());
          out.number(line.txIdleChars());
        }

        @Override
        ToolConnector read(ByteSource in) throws MalformedBytes {
          return new ToolConnector(
              in.integer(),
              in.constant(ToolOutputMode.class),
              in.constant(ToolPinMode.class),
              in.constant(ToolPinMode.class),
              new ToolCommunication(
                  in.bool(),
                  in.integer(),
                  in.constant(ToolCommunication.Parity.class),
                  in.integer(),
                  (float) in.number(),
                  (float) in.number()));
        }
      };

  private static final Form<RegisterLevels> REGISTERS =
      new Form<>() {
        @Override
        void write(RegisterLevels value, ByteSink out) {
          out.longOf(value.lowBits());
          out.longOf(value.highBits());
          for (int i = 0; i < RegisterKind.INTEGER.size(); i++) {
            out.whole(value.integer(i));
          }
          for (int i = 0; i < RegisterKind.FLOAT.size(); i++) {
            out.number(value.floating(i));
          }
        }

        @Override
        RegisterLevels read(ByteSource in) throws MalformedBytes {
          long low = in.longOf();
          long high = in.longOf();
          int[] integers = new int[RegisterKind.INTEGER.size()];
          for (int i = 0; i < integers.length; i++) {
            integers[i] = in.integer();
          }
          double[] floats = new double[RegisterKind.FLOAT.size()];
          for (int i = 0; i < floats.length; i++) {
            floats[i] = in.number();
          }
          return RegisterLevels.of(low, high, integers, floats);
        }
      };

  private static final Form<PortLevels> PORT =
      new Form<>() {
        @Override
        void write(PortLevels value, ByteSink out) {
          out.longOf(value.lowBits());
          out.longOf(value.highBits());
          for (int i = 0; i < PORTS; i++) {
            out.whole(value.register(PortLevels.FIRST + i));
          }
        }

        @Override
        PortLevels read(ByteSource in) throws MalformedBytes {
          long low = in.longOf();
          long high = in.longOf();
          short[] registers = new short[PORTS];
          for (int i = 0; i < PORTS; i++) {
            registers[i] = (short) in.integer();
          }
          return PortLevels.of(low, high, registers);
        }
      };

  private static final Form<InputActions> ACTIONS =
      new Form<>() {
        @Override
        void write(InputActions value, ByteSink out) {
          out.whole(value.standard());
          out.whole(value.configurable());
          out.whole(value.tool());
          out.longOf(value.lowRegisters());
          out.longOf(value.highRegisters());
        }

        @Override
        InputActions read(ByteSource in) throws MalformedBytes {
          return new InputActions(
              in.integer(), in.integer(), in.integer(), in.longOf(), in.longOf());
        }
      };

  static final Form<SignalState> SIGNALS =
      new Form<>() {
        @Override
        void write(SignalState value, ByteSink out) {
          ANALOG.write(value.analog(), out);
          TOOL.write(value.tool(), out);
          REGISTERS.write(value.inputs(), out);
          REGISTERS.write(value.outputs(), out);
          PORT.write(value.ports(), out);
          ACTIONS.write(value.actions(), out);
        }

        @Override
        SignalState read(ByteSource in) throws MalformedBytes {
          return new SignalState(
              ANALOG.read(in),
              TOOL.read(in),
              REGISTERS.read(in),
              REGISTERS.read(in),
              PORT.read(in),
              ACTIONS.read(in));
        }
      };

  static final Form<Encoders.Counts> ENCODERS =
      new Form<>() {
        @Override
        void write(Encoders.Counts value, ByteSink out) {
          out.whole(value.first());
          out.whole(value.second());
        }

        @Override
        Encoders.Counts read(ByteSource in) throws MalformedBytes {
          return new Encoders.Counts(in.integer(), in.integer());
        }
      };

  private SignalForms() {}
}
