package org.pendant.desktop.debug;

import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.function.Function;
import org.pendant.controller.DebugCommand;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.Reply;
import org.pendant.kit.text.Messages;
import org.pendant.language.source.ByteText;
import org.pendant.script.value.ScriptError;

/** Session link: reaches the debugger by commands. */
final class SessionLink implements DebugLink {
  private final Function<Command, CompletableFuture<Reply>> submit;
  private final Executor display;

  /**
   * @param submit leaves a command for the next frame
   * @param display where answers are told
   */
  SessionLink(Function<Command, CompletableFuture<Reply>> submit, Executor display) {
    this.submit = submit;
    this.display = display;
  }

  @Override
  public <T> void ask(Request<T> request, Consumer<T> answer, Consumer<String> refusal) {
    CompletableFuture<T> found = new CompletableFuture<>();
    DebugCommand.Debug command =
        new DebugCommand.Debug(
            debugger -> {
              try {
                found.complete(request.of(debugger));
              } catch (ScriptError e) {
                throw new IllegalArgumentException(e.getMessage(), e);
              }
            });
    var _ =
        submit
            .apply(command)
            .thenAccept(
                reply ->
                    display.execute(
                        () -> {
                          Optional<String> why = reply.complaint();
                          if (why.isPresent()) {
                            refusal.accept(Messages.shown(ByteText.decoded(why.get())));
                          } else {
                            answer.accept(found.join());
                          }
                        }));
  }

  @Override
  public void resume(Consumer<String> refusal) {
    var _ =
        submit
            .apply(new ProgramCommand.ResumeProgram())
            .thenAccept(
                reply ->
                    reply.complaint().ifPresent(why -> display.execute(() -> refusal.accept(why))));
  }
}
