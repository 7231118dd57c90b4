package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.io.InputStream;
import java.io.OutputStream;
import java.util.List;
import org.pendant.command.service.Version;
import org.pendant.editors.lsp.LanguageServerConnection;

/** Command {@code pendant lsp}: the language server, for editors. */
final class LspCommand implements Subcommand {
  static final Option PORT =
      Option.of("--port", new OptionArgument.Whole("P", 1, 65535))
          .documented(
              "P",
              "wait for editors at this port of 127.0.0.1, each with a session of its own, instead"
                  + " of serving the one at standard input and output");

  private final EditorServer server;

  LspCommand(InputStream input, OutputStream output) {
    server = new EditorServer(name(), input, output);
  }

  @Override
  public String name() {
    return "lsp";
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
    return server.run(
        arguments.whole(PORT),
        console,
        (in, out) ->
            LanguageServerConnection.serve(
                Version.line(),
                in,
                out,
                fault -> console.complainOf("pendant lsp", fault),
                complaint -> console.complain("pendant lsp: " + complaint)));
  }
}
