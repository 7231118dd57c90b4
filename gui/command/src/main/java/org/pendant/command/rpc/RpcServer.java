package org.pendant.command.rpc;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;

/**
 * RPC server: answers JSON-RPC 2.0, one object a line, until its input ends. One thread does all of
 * it, so requests are carried out in their order.
 */
public final class RpcServer {
  /** Where answers go. */
  public interface Output {
    /** Writes a line of ASCII, and hands it to the reader. */
    void line(String ascii);

    /** Whether nobody reads any more. */
    boolean closed();
  }

  private final RobotSource source;
  private final String version;
  private final Output output;
  private final Consumer<Throwable> faults;

  /**
   * A server.
   *
   * @param source makes robots
   * @param version of Pendant, as {@code --version} tells it
   * @param faults is told of faults in Pendant
   */
  public RpcServer(RobotSource source, String version, Output output, Consumer<Throwable> faults) {
    this.source = source;
    this.version = version;
    this.output = output;
    this.faults = faults;
  }

  /**
   * Answers requests until there are none any more, or nobody reads the answers.
   *
   * @throws IOException if the input cannot be read
   */
  public void serve(InputStream input) throws IOException {
    try (Robots robots = new Robots(source)) {
      Dispatcher dispatcher = new Dispatcher(methods(robots), faults);
      LineReader lines = new LineReader(input);
      boolean more = true;
      while (more && !output.closed()) {
        try {
          Optional<ByteBuffer> line = lines.next();
          more = line.isPresent();
          line.flatMap(dispatcher::answer).ifPresent(output::line);
        } catch (RpcFailure tooLong) {
          output.line(Dispatcher.refusal(tooLong));
        }
      }
    }
  }

  private MethodTable methods(Robots robots) {
    MethodTable table = new MethodTable(robots);
    table.add(
        "server.info",
        params -> {
          params.allow();
          Map<String, Object> info = new LinkedHashMap<>();
          info.put("version", version);
          info.put("methods", table.names());
          return info;
        });
    robots.declareIn(table);
    ProgramMethods.declareIn(table);
    TimeMethods.declareIn(table);
    ReadingMethods.declareIn(table);
    ControlMethods.declareIn(table);
    CellMethods.declareIn(table);
    RecordingMethods.declareIn(table);
    return table;
  }
}
