package org.pendant.desktop.debug;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.function.Function;
import org.pendant.controller.Command;
import org.pendant.controller.Reply;
import org.pendant.language.source.ByteText;
import org.pendant.script.value.ScriptError;

/** Reaches the debugger by commands. */
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
    Command.Debug command =
        new Command.Debug(
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
                          if (reply instanceof Reply.Refused refused) {
                            refusal.accept(ByteText.decoded(refused.reason()));
                          } else {
                            answer.accept(found.join());
                          }
                        }));
  }
}
