package org.pendant.command;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.pendant.editors.dap.DebugAdapterConnection;
import org.pendant.editors.wire.LoopbackListener;
import org.pendant.editors.wire.ProtocolLog;

/** Command {@code pendant dap}: the debug adapter, for editors. */
final class DapCommand implements Subcommand {
  static final Option PORT =
      Option.of(
              "--port",
              new OptionArgument.Whole("P", 1, 65535),
              "serve editors that connect to this port of 127.0.0.1, not standard input and output")
          .documented(
              "P",
              "wait for editors at this port of 127.0.0.1, each with a robot of its own, instead of"
                  + " serving the one at standard input and output");

  private final InputStream input;
  private final OutputStream output;

  DapCommand(InputStream input, OutputStream output) {
    this.input = input;
    this.output = output;
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
  public String summary() {
    return "let editors debug programs: an adapter of the Debug Adapter Protocol";
  }

  @Override
  public List<Option> options() {
    return List.of(PORT);
  }

  @Override
  public ExitCode run(Arguments arguments, Console console) throws UsageException {
    if (!arguments.operands().isEmpty()) {
      throw new UsageException("takes no file, it was given " + arguments.operands().getFirst());
    }
    OptionalInt port = arguments.whole(PORT);
    try (ProtocolLog _ = new ProtocolLog(line -> console.complain("pendant dap: " + line))) {
      if (port.isPresent()) {
        return listen(port.getAsInt(), console);
      }
      serve(input, output, console);
      return ExitCode.DONE;
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return ExitCode.DONE;
    }
  }

  private static ExitCode listen(int port, Console console) throws UsageException {
    try (LoopbackListener listener = new LoopbackListener(port)) {
      console.complain("pendant dap: listening at 127.0.0.1:" + listener.port());
      listener.serve((in, out) -> serve(in, out, console));
      return ExitCode.DONE;
    } catch (IOException e) {
      throw new UsageException("port " + port + " cannot be opened: " + e.getMessage());
    }
  }

  private static void serve(InputStream in, OutputStream out, Console console)
      throws InterruptedException {
    DebugAdapterConnection.serve(
        new DebuggedPrograms(),
        Optional.empty(),
        in,
        out,
        fault -> tell(fault, console),
        complaint -> console.complain("pendant dap: " + complaint));
  }

  private static void tell(Throwable fault, Console console) {
    StringWriter details = new StringWriter();
    fault.printStackTrace(new PrintWriter(details, true));
    console.complain("pendant dap: internal error: " + fault);
    console.complainInLines(details.toString().stripTrailing());
  }
}
