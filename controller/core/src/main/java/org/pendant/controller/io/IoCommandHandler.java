package org.pendant.controller.io;

import static org.pendant.controller.io.SignalTexts.text;

import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.pendant.controller.command.CommandHandler;
import org.pendant.controller.command.Refusal;
import org.pendant.controller.command.Reply;

/** Handler of the commands about signals. */
public final class IoCommandHandler implements CommandHandler<IoCommand> {
  private final Signals signals;
  private final Supplier<Optional<String>> activeProgram;

  /**
   * For the signals of one box.
   *
   * @param activeProgram name of the program that runs or is paused
   */
  public IoCommandHandler(Signals signals, Supplier<Optional<String>> activeProgram) {
    this.signals = signals;
    this.activeProgram = activeProgram;
  }

  @Override
  public Class<IoCommand> family() {
    return IoCommand.class;
  }

  @Override
  public Reply carryOut(IoCommand command) {
    return switch (command) {
      case IoCommand.SetInput(String name, boolean level) -> {
        signals.digital().setInput(name, level);
        yield Reply.done();
      }
      case IoCommand.WriteSignals(String writer, List<SignalWrite> writes) ->
          Reply.unless(write(writer, writes));
      case IoCommand.ClaimSignal(String owner, String signal) ->
          Reply.unless(signals.owners().claim(signal, owner));
      case IoCommand.PlayInputs(InputWaveforms waveforms) -> {
        signals.player().set(waveforms);
        yield Reply.done();
      }
      case IoCommand.ReleaseSignals(String owner) -> {
        signals.owners().release(owner);
        yield Reply.done();
      }
    };
  }

  /** Why a change of signals is refused; nothing has changed then. */
  private Optional<Refusal> write(String writer, List<SignalWrite> writes) {
    Optional<String> program =
        writer.equals(InputOwners.BY_HAND) ? activeProgram.get() : Optional.empty();
    for (SignalWrite write : writes) {
      Optional<Refusal> refusal = signals.owners().refusal(write.name(), writer);
      if (refusal.isPresent()) {
        return refusal;
      }
      if (!write.input() && program.isPresent()) {
        return Optional.of(
            new Refusal(
                Refusal.Code.PROGRAM, text("programHasOutputs", write.name(), program.get())));
      }
    }
    writes.forEach(signals::write);
    return Optional.empty();
  }
}
