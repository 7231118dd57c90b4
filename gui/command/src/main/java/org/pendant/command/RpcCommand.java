package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.io.IOException;
import java.io.InputStream;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import org.pendant.command.rpc.RobotSource;
import org.pendant.command.rpc.RpcFailure;
import org.pendant.command.rpc.RpcServer;
import org.pendant.command.service.Version;
import org.pendant.protocols.externalcontrol.NoScript;

/**
 * Command {@code pendant rpc}: lets programs in other languages drive robots in virtual time, by
 * JSON-RPC over standard input and output.
 */
final class RpcCommand implements Subcommand {
  private static final Pattern DASHES = Pattern.compile("(?<!\\S)--(?=[a-z])");

  private final InputStream input;

  RpcCommand(InputStream input) {
    this.input = input;
  }

  @Override
  public String name() {
    return "rpc";
  }

  @Override
  public String operands() {
    return "";
  }

  @Override
  public List<Option> options() {
    return List.of();
  }

  @Override
  public ExitCode run(Arguments arguments, Console console) throws UsageException {
    if (!arguments.operands().isEmpty()) {
      throw new UsageException(text("takesNoFile", arguments.operands().getFirst()));
    }
    RpcServer.Output output =
        new RpcServer.Output() {
          @Override
          public void line(String ascii) {
            console.printBytes(ascii);
            console.flush();
          }

          @Override
          public boolean closed() {
            return console.outputClosed();
          }
        };
    try {
      new RpcServer(
              RpcCommand::robot,
              Version.line(),
              output,
              fault -> console.complainOf("pendant rpc", fault))
          .serve(input);
      return ExitCode.DONE;
    } catch (IOException e) {
      console.complain(text("inputCannotBeRead", e.getMessage()));
      return ExitCode.WRONG_USAGE;
    }
  }

  private static RobotSource.NewRobot robot(List<String> words) throws RpcFailure {
    try {
      Arguments arguments = Arguments.parse(RunOptions.OF_ROBOT, words);
      CellFile.refuse(arguments);
      RunOptions options = RunOptions.of(arguments);
      return new RobotSource.NewRobot(
          options.controller(),
          options.waveforms(),
          options.hosts(),
          file -> program(arguments, options, file));
    } catch (UsageException e) {
      // options are parameters here, and have no dashes
      throw new RpcFailure(
          RpcFailure.INVALID_PARAMS, DASHES.matcher(e.getMessage()).replaceAll(""));
    }
  }

  private static RobotSource.ReadProgram program(
      Arguments arguments, RunOptions options, String name) throws RpcFailure {
    try {
      RunnableFile file =
          RunnableFile.read(arguments, List.of(name)).getFirst().asked(options.drivers());
      return new RobotSource.ReadProgram(
          file.source(), file.notes(), file.problems(), file::nodeAt);
    } catch (UsageException | NoScript e) {
      throw new RpcFailure(
          RpcFailure.UNREADABLE, String.valueOf(e.getMessage()), Map.of("file", name));
    }
  }
}
