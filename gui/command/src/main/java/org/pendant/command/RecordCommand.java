package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.io.IOException;
import java.net.ConnectException;
import java.net.InetSocketAddress;
import java.net.NoRouteToHostException;
import java.net.SocketTimeoutException;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import org.pendant.controller.disk.FileTrouble;
import org.pendant.protocols.rtde.ReceivedField;
import org.pendant.protocols.rtde.RtdeClient;

/**
 * Command {@code pendant record}: writes what a controller, of Pendant or of a real robot, sends by
 * RTDE to a table or a recording.
 */
final class RecordCommand implements Subcommand {
  /** A controller that sends nothing for so long is gone. */
  private static final long SILENCE_NS = TimeUnit.SECONDS.toNanos(5);

  @Override
  public String name() {
    return "record";
  }

  @Override
  public String operands() {
    return "";
  }

  @Override
  public List<Option> options() {
    return RecordOptions.ALL;
  }

  @Override
  public ExitCode run(Arguments arguments, Console console) throws UsageException {
    RecordOptions options = RecordOptions.of(arguments);
    if (!arguments.operands().isEmpty()) {
      throw new UsageException(text("takesNoFile", arguments.operands().getFirst()));
    }
    String place = options.host() + ":" + options.port();
    Interruption interruption = Interruption.listen("theRecording");
    try (interruption;
        RtdeClient client = connect(options)) {
      List<ReceivedField> fields = subscribe(client, options, console);
      console.complain(text("controllerVersion", place, client.controllerVersion()));
      interruption.hold();
      ExitCode code = record(client, fields, options, interruption, console);
      console.flush();
      interruption.closeWith(code);
      return code;
    } catch (IOException e) {
      console.complain("pendant record: " + place + ": " + reason(e));
      return ExitCode.UNAVAILABLE;
    }
  }

  private static RtdeClient connect(RecordOptions options) throws IOException {
    InetSocketAddress address = new InetSocketAddress(options.host(), options.port());
    if (address.isUnresolved()) {
      throw new IOException(text("noComputer"));
    }
    return RtdeClient.connect(address);
  }

  private static String reason(IOException e) {
    return switch (e) {
      case ConnectException _ -> text("nothingListens");
      case NoRouteToHostException _ -> text("noWay");
      case SocketTimeoutException late -> text("cannotBeReached", late.getMessage());
      default -> String.valueOf(e.getMessage());
    };
  }

  /** Fields that people have named must be there; of the others those are left out that are not. */
  private static List<ReceivedField> subscribe(
      RtdeClient client, RecordOptions options, Console console)
      throws IOException, UsageException {
    List<String> names = new ArrayList<>(options.fields());
    while (true) {
      switch (client.subscribe(options.frequencyHz(), names)) {
        case RtdeClient.Subscription.Granted granted -> {
          return granted.fields();
        }
        case RtdeClient.Subscription.Unknown unknown -> {
          String missing = String.join(", ", unknown.names());
          if (options.chosen() || !names.removeAll(unknown.names()) || names.isEmpty()) {
            throw new UsageException(text("noField", missing));
          }
          console.complain(text("fieldLeftOut", missing));
        }
      }
    }
  }

  private static ExitCode record(
      RtdeClient client,
      List<ReceivedField> fields,
      RecordOptions options,
      Interruption interruption,
      Console console)
      throws UsageException {
    List<ReceivedFile> files = new ArrayList<>();
    try {
      for (OutputFile each : options.out()) {
        files.add(
            RecordOptions.isRecording(each)
                ? ReceivedFile.recording(each, fields, options.arm().orElseThrow())
                : ReceivedFile.table(each, fields, options.separator()));
      }
      ExitCode code = new Rows(client, options, files).write(interruption, console);
      for (ReceivedFile each : files) {
        each.end();
      }
      return code;
    } finally {
      for (ReceivedFile each : files) {
        close(each);
      }
    }
  }

  private static void close(ReceivedFile file) throws UsageException {
    try {
      file.close();
    } catch (IOException e) {
      throw new UsageException(text("draftStays", file.shortName(), FileTrouble.reason(e)));
    }
  }

  /** What the controller sends, row by row. */
  private static final class Rows {
    private static final int ROWS_A_FLUSH = 64;

    private final RtdeClient client;
    private final RecordOptions options;
    private final List<ReceivedFile> files;
    private long count;

    Rows(RtdeClient client, RecordOptions options, List<ReceivedFile> files) {
      this.client = client;
      this.options = options;
      this.files = files;
    }

    /**
     * Writes rows until there are enough, people want no more, or the controller is gone.
     *
     * @throws UsageException if a file cannot be written
     */
    ExitCode write(Interruption interruption, Console console) throws UsageException {
      double wanted = options.seconds().orElse(Double.POSITIVE_INFINITY) * options.frequencyHz();
      Optional<String> lost = Optional.empty();
      try {
        client.start();
      } catch (IOException e) {
        lost = Optional.of(reason(e));
      }
      long heardNs = System.nanoTime();
      while (lost.isEmpty() && count < wanted && !interruption.requested()) {
        Optional<ByteBuffer> data = Optional.empty();
        try {
          data = client.next();
        } catch (IOException e) {
          lost = Optional.of(reason(e));
        }
        if (data.isPresent()) {
          heardNs = System.nanoTime();
          write(data.get());
        } else if (lost.isEmpty() && System.nanoTime() - heardNs > SILENCE_NS) {
          lost = Optional.of(text("sendsNothing"));
        }
      }
      String written =
          String.format(
              Locale.ROOT,
              text("rowsAreIn"),
              count,
              count / options.frequencyHz(),
              files.stream().map(ReceivedFile::shortName).collect(Collectors.joining(", ")));
      if (lost.isPresent()) {
        console.complain(text("connectionLost", lost.get(), written));
        return ExitCode.UNAVAILABLE;
      }
      console.complain("pendant record: " + written);
      return ExitCode.DONE;
    }

    private void write(ByteBuffer data) throws UsageException {
      count++;
      for (ReceivedFile each : files) {
        each.write(data);
        if (count % ROWS_A_FLUSH == 0) {
          each.flush();
        }
      }
    }
  }
}
