package org.pendant.desktop.program.form;

import static org.pendant.desktop.program.form.FormTexts.text;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.pendant.project.program.ActionStep;
import org.pendant.project.program.PlaceNames;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.Section;
import org.pendant.project.program.WaypointPosition;
import org.pendant.project.program.text.ProgramText;
import org.pendant.project.program.text.ReadProgram;

/**
 * File parts: what forms do with files: a script that is pasted, a program that becomes a sub
 * program.
 */
final class FileParts {
  private FileParts() {}

  static NodeForm scriptFile(FormContext context, ActionStep.ScriptFile step) {
    FormBuilder form =
        new FormBuilder(
            context, "script-file", text("scriptFile"), text("urscriptOfAFileTheProgram"));
    form.part(text("file"));
    addFile(
        form,
        step.file(),
        ".script",
        (file, text) ->
            context.change(
                text("read", file),
                context
                    .host()
                    .tree()
                    .withStep(
                        context.key(),
                        new ActionStep.ScriptFile(file, text.stripTrailing().lines().toList()))));
    form.part(text("copyInTheProgram"));
    if (step.lines().isEmpty()) {
      form.quiet("empty", text("nothingHasBeenReadYet"));
    } else {
      form.add(new Item.Code("lines", "", String.join("\n", step.lines()), true, Optional.empty()));
    }
    return form.build();
  }

  static void addSubProgram(FormBuilder form, Section.SubProgram sub) {
    FormContext context = form.context();
    form.part(text("copyOfAProgram"));
    form.quiet("file-hint", text("aProgramFileCanBeCopied"));
    addFile(
        form,
        sub.file(),
        ".pendant",
        (file, text) -> {
          ReadProgram read = ProgramText.read(text);
          if (read.problems().isEmpty()) {
            context.change(
                text("copy", file),
                copied(
                    context.host().tree(),
                    context.key(),
                    new Section.SubProgram(sub.name(), file),
                    read.tree()));
          } else {
            context.host().notify(text("cannotBeRead", file, read.problems().getFirst().message()));
          }
        });
  }

  /** What is done with a file that has been read. */
  @FunctionalInterface
  private interface Use {
    void take(String file, String text);
  }

  private static void addFile(FormBuilder form, String file, String ending, Use use) {
    FormContext context = form.context();
    form.quiet("file", file.isEmpty() ? text("noFileChosen") : text("fileNamed", file));
    Consumer<Path> read =
        path ->
            context
                .files()
                .read(
                    path,
                    text -> use.take(name(context, path), text),
                    why -> context.host().notify(why));
    form.presses(
        "file-buttons",
        "",
        FormBuilder.press(
            "file-choose",
            text("choose"),
            text("chooseAFileAndReadIt"),
            true,
            () -> context.files().choose(text("chooseAFile"), ending, read)),
        FormBuilder.press(
            "file-reload",
            text("readAgain"),
            text("readTheFileAsItIs"),
            !file.isEmpty(),
            () -> read.accept(path(context, file))));
  }

  private static Path path(FormContext context, String file) {
    return context.host().folder().map(folder -> folder.resolve(file)).orElse(Path.of(file));
  }

  /** Relative to the program, if that has a place and there is a way from it. */
  private static String name(FormContext context, Path path) {
    Path whole = path.toAbsolutePath().normalize();
    return context
        .host()
        .folder()
        .map(folder -> folder.toAbsolutePath().normalize())
        .filter(folder -> folder.getRoot().equals(whole.getRoot()))
        .map(folder -> folder.relativize(whole).toString().replace('\\', '/'))
        .orElse(whole.toString());
  }

  /**
   * The program with the main program of another one as a sub program. Places of the other one get
   * new names where this one has others of the same name.
   */
  static ProgramTree copied(ProgramTree tree, long key, Section.SubProgram sub, ProgramTree other) {
    List<Long> old = tree.childrenOf(key).stream().map(ProgramNode::key).toList();
    ProgramTree result = tree.remove(old).withStep(key, sub);
    ProgramTree source = other;
    for (Map.Entry<String, WaypointPosition> each : other.waypoints().entrySet()) {
      String name = each.getKey();
      WaypointPosition present = result.waypoints().get(name);
      boolean used = WaypointNames.uses(result, name) > 0;
      if (present != null && used && !present.equals(each.getValue())) {
        String free = free(result, source, name);
        source = PlaceNames.renamed(source, name, free);
        name = free;
      }
      result = result.withWaypoint(name, each.getValue());
    }
    List<ProgramNode> added =
        source.sections().stream()
            .filter(node -> node.step() instanceof Section.MainProgram)
            .flatMap(node -> node.children().stream())
            .toList();
    return result.insert(key, 0, added);
  }

  private static String free(ProgramTree one, ProgramTree other, String name) {
    int number = 1;
    String free = name + "_" + number;
    while (WaypointNames.of(one).contains(free) || WaypointNames.of(other).contains(free)) {
      number++;
      free = name + "_" + number;
    }
    return free;
  }
}
