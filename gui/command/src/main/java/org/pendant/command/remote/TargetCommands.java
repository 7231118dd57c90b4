package org.pendant.command.remote;

import static org.pendant.command.remote.TargetTexts.text;

import java.io.Closeable;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.box.BoxCommand;
import org.pendant.controller.box.MessageCommand;
import org.pendant.controller.command.Command;
import org.pendant.controller.io.IoCommand;
import org.pendant.controller.io.SignalWrite;
import org.pendant.controller.safety.SafetyCommand;
import org.pendant.protocols.dashboard.DashboardClient;
import org.pendant.protocols.rtde.RtdeInputs;
import org.pendant.testing.remote.TargetState;
import org.pendant.testing.remote.TargetTrouble;

/** Target commands: what tests ask for, by the dashboard and the inputs of RTDE. */
final class TargetCommands implements Closeable {
  private static final int LOW_BITS = 32;
  private static final int SINGLE_BITS = 64;
  private static final String LOW = "input_bit_registers0_to_31";
  private static final String HIGH = "input_bit_registers32_to_63";

  private final DashboardClient dashboard;
  private final InetSocketAddress rtde;
  private Optional<RtdeInputs> inputs = Optional.empty();
  private double speedAtFirst = 1;
  private boolean speedChanged;
  private boolean bitsKnown;
  private long bits;
  private TargetState state = new TargetState(Map.of());

  /**
   * Commands of a robot.
   *
   * @param rtde where inputs are written, over a connection that is made for the first of them
   */
  TargetCommands(DashboardClient dashboard, InetSocketAddress rtde) {
    this.dashboard = dashboard;
    this.rtde = rtde;
  }

  /** A test begins. */
  void begin(TargetState now) {
    speedAtFirst = now.number(TargetState.SPEED, 1);
    speedChanged = false;
  }

  /** A state has come. */
  void see(TargetState now) {
    state = now;
  }

  /**
   * Carries a command out.
   *
   * @return why not
   */
  Optional<String> carryOut(Command command) throws TargetTrouble {
    return switch (command) {
      case ProgramCommand.StopProgram _ -> say("stop", "Stopped");
      case ProgramCommand.PauseProgram _ -> say("pause", "Pausing program");
      case ProgramCommand.ResumeProgram _ -> say("play", "Starting program");
      case MessageCommand.AnswerPopup _ -> say("close popup", "closing popup");
      case SafetyCommand.UnlockProtectiveStop _ ->
          say("unlock protective stop", "Protective stop releasing");
      case BoxCommand.SetSpeedFraction speed -> {
        speedChanged = true;
        yield speed(speed.fraction());
      }
      case IoCommand.WriteSignals writes -> write(writes.writes());
      default -> Optional.of(text("nothingForPorts", command.getClass().getSimpleName()));
    };
  }

  private Optional<String> say(String line, String expected) throws TargetTrouble {
    try {
      String answer = dashboard.ask(line);
      return answer.startsWith(expected) ? Optional.empty() : Optional.of(line + ": " + answer);
    } catch (IOException e) {
      throw new TargetTrouble(text("dashboard", RobotTarget.reason(e)));
    }
  }

  private Optional<String> speed(double fraction) throws TargetTrouble {
    return write(List.of("speed_slider_mask", "speed_slider_fraction"), List.of(1.0, fraction));
  }

  private Optional<String> write(List<SignalWrite> writes) throws TargetTrouble {
    Optional<String> refusal = Optional.empty();
    for (SignalWrite each : writes) {
      refusal =
          switch (each) {
            case SignalWrite.IntegerRegister(var _, var address, var value) ->
                write(List.of("input_int_register_" + address), List.of((double) value));
            case SignalWrite.FloatRegister(var _, var address, var value) ->
                write(List.of("input_double_register_" + address), List.of(value));
            case SignalWrite.BooleanRegister(var _, var address, var value) ->
                writeBit(address, value);
            default -> Optional.of(text("nothingForPorts", each.name()));
          };
      if (refusal.isPresent()) {
        return refusal;
      }
    }
    return refusal;
  }

  /** The first 64 are written together, so that the others keep what they had. */
  private Optional<String> writeBit(int address, boolean value) throws TargetTrouble {
    if (address >= SINGLE_BITS) {
      return write(List.of("input_bit_register_" + address), List.of(value ? 1.0 : 0.0));
    }
    if (!bitsKnown) {
      bits = (long) state.number(LOW, 0) | (long) state.number(HIGH, 0) << LOW_BITS;
      bitsKnown = true;
    }
    bits = value ? bits | 1L << address : bits & ~(1L << address);
    boolean low = address < LOW_BITS;
    return write(
        List.of(low ? LOW : HIGH),
        List.of((double) (low ? bits & 0xFFFFFFFFL : bits >>> LOW_BITS)));
  }

  private Optional<String> write(List<String> names, List<Double> values) throws TargetTrouble {
    try {
      if (inputs.isEmpty()) {
        inputs = Optional.of(RtdeInputs.connect(rtde));
      }
      inputs.get().write(names, values);
      return Optional.empty();
    } catch (IOException e) {
      return Optional.of(text("rtde", RobotTarget.reason(e)));
    }
  }

  /** A test has ended. */
  void end() throws TargetTrouble {
    if (speedChanged) {
      var _ = speed(speedAtFirst);
    }
  }

  @Override
  public void close() throws IOException {
    if (inputs.isPresent()) {
      inputs.get().close();
    }
  }
}
