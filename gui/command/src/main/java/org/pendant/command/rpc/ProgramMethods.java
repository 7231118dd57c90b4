package org.pendant.command.rpc;

import static org.pendant.command.rpc.RpcTexts.text;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.IntFunction;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.file.ProgramsFolder;
import org.pendant.language.source.ByteText;
import org.pendant.language.source.Diagnostic;
import org.pendant.language.source.Source;
import org.pendant.script.vm.LoadResult;
import org.pendant.script.vm.Program;

/** Methods about programs: load, start, stop, pause. */
final class ProgramMethods {
  private ProgramMethods() {}

  static void declareIn(MethodTable table) {
    table.add("program.load", List.of("file", "text", "name"), ProgramMethods::load);
    table.add("program.start", List.of(), (robot, params) -> start(robot));
    table.add("program.stop", List.of(), asking(new ProgramCommand.StopProgram()));
    table.add("program.pause", List.of(), asking(new ProgramCommand.PauseProgram()));
    table.add("program.resume", List.of(), asking(new ProgramCommand.ResumeProgram()));
  }

  private static RpcMethod.OfRobot asking(ProgramCommand command) {
    return (robot, params) -> {
      robot.ask(command);
      return Map.of();
    };
  }

  private static Object load(DrivenRobot robot, RpcParams params) throws RpcFailure {
    Optional<String> file = params.text("file");
    Optional<String> text = params.text("text");
    if (file.isPresent() == text.isPresent()) {
      throw RpcFailure.params(text("fileOrText"));
    }
    robot.load(Optional.empty());
    if (text.isPresent()) {
      String name = params.text("name").orElse("program.script");
      Source source = Source.of(name, ByteText.asBytes(text.get()));
      return load(robot, source, Optional.empty(), name, List.of(), line -> Optional.empty());
    }
    if (params.has("name")) {
      throw RpcFailure.params(text("nameWithText"));
    }
    RobotSource.ReadProgram read = robot.programs().read(file.get());
    if (read.source().isEmpty()) {
      return answer(file.get(), false, read.notes(), problems(file.get(), read.problems()));
    }
    return load(
        robot,
        read.source().get(),
        Optional.of(ProgramsFolder.of(file.get())),
        file.get(),
        read.notes(),
        read.node());
  }

  private static Object load(
      DrivenRobot robot,
      Source source,
      Optional<ProgramsFolder> folder,
      String file,
      List<String> notes,
      IntFunction<Optional<String>> node) {
    LoadResult result = robot.robot().load(source);
    robot.load(
        result.program().map(program -> new DrivenRobot.Loaded(program, folder, source.name())));
    List<Map<String, Object>> diagnostics = new ArrayList<>();
    for (Diagnostic each : result.diagnostics()) {
      diagnostics.add(diagnostic(source, each, node));
    }
    return answer(file, result.program().isPresent(), notes, diagnostics);
  }

  private static Map<String, Object> answer(
      String file, boolean loaded, List<String> notes, List<Map<String, Object>> diagnostics) {
    Map<String, Object> all = new LinkedHashMap<>();
    all.put("file", file);
    all.put("loaded", loaded);
    all.put("diagnostics", diagnostics);
    all.put("notes", notes);
    return all;
  }

  private static List<Map<String, Object>> problems(String file, List<String> problems) {
    List<Map<String, Object>> all = new ArrayList<>();
    for (String each : problems) {
      Map<String, Object> one = new LinkedHashMap<>();
      one.put("file", file);
      one.put("line", 1);
      one.put("column", 1);
      one.put("severity", "error");
      one.put("code", "tree");
      one.put("message", each);
      all.add(one);
    }
    return all;
  }

  private static Map<String, Object> diagnostic(
      Source source, Diagnostic diagnostic, IntFunction<Optional<String>> node) {
    int start = diagnostic.range().start();
    Map<String, Object> one = new LinkedHashMap<>();
    one.put("file", source.name());
    one.put("line", source.line(start));
    one.put("column", source.column(start));
    one.put("end_line", source.line(diagnostic.range().end()));
    one.put("end_column", source.column(diagnostic.range().end()));
    one.put("severity", diagnostic.isError() ? "error" : "warning");
    one.put("code", diagnostic.code());
    one.put("message", ByteText.decoded(diagnostic.message()));
    node.apply(source.line(start)).ifPresent(place -> one.put("node", place));
    return one;
  }

  private static Object start(DrivenRobot robot) throws RpcFailure {
    DrivenRobot.Loaded loaded =
        robot
            .loaded()
            .orElseThrow(() -> new RpcFailure(RpcFailure.PROGRAM, text("noProgramLoaded")));
    Program program = loaded.program();
    if (program.secondary()) {
      robot.ask(new ProgramCommand.RunSecondary(program, loaded.folder()));
    } else {
      robot.ask(new ProgramCommand.StartProgram(program, loaded.folder()));
      robot.started(loaded.file());
    }
    return Map.of();
  }
}
