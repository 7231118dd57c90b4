package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.io.InputStream;
import java.io.OutputStream;
import java.util.List;
import java.util.Optional;
import org.pendant.editors.dap.DebugAdapterConnection;

/** Command {@code pendant dap}: the debug adapter, for editors. */
final class DapCommand implements Subcommand {
  static final Option PORT =
      Option.of("--port", new OptionArgument.Whole("P", 1, 65535))
          .documented(
              "P",
              "wait for editors at this port of 127.0.0.1, each with a robot of its own, instead of"
                  + " serving the one at standard input and output");

  private final EditorServer server;

  DapCommand(InputStream input, OutputStream output) {
    server = new EditorServer(name(), input, output);
  }

  @Override
  public String name() {
    return "dap";
  }

  @Override
  public String operands() {
    return "";
  }

  @Override
  public List<Option> options() {
    return List.of(PORT);
  }

  @Override
  public ExitCode run(Arguments arguments, Console console) throws UsageException {
    if (!arguments.operands().isEmpty()) {
      throw new UsageException(text("takesNoFile", arguments.operands().getFirst()));
    }
    return server.run(arguments.whole(PORT), console, (in, out) -> serve(in, out, console));
  }

  private static boolean serve(InputStream in, OutputStream out, Console console)
      throws InterruptedException {
    DebugAdapterConnection.serve(
        new DebuggedPrograms(),
        Optional.empty(),
        in,
        out,
        fault -> console.complainOf("pendant dap", fault),
        complaint -> console.complain("pendant dap: " + complaint));
    return true;
  }
}
