package org.pendant.desktop.program;

import static org.pendant.desktop.program.ProgramViewTexts.text;

import java.util.Optional;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.debug.ProgramLaunch;
import org.pendant.desktop.debug.RunLines;
import org.pendant.desktop.debug.RunScript;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.language.source.Source;
import org.pendant.project.program.ExternalControl;
import org.pendant.project.program.FirstWaypoint;
import org.pendant.project.program.PlayFrom;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.Section;
import org.pendant.project.program.script.GeneratedScript;
import org.pendant.project.program.script.ScriptGenerator;

/**
 * Tree runs: programs that are trees as they run: from their beginning or from a node. Everywhere 0
 * stands for the beginning in place of a node's key. One thread uses it, the dispatch thread.
 */
public final class TreeRuns {
  private final TreePrograms trees;
  private final ScriptLink link;

  /** Runs of {@code trees}. */
  public TreeRuns(TreePrograms trees, ScriptLink link) {
    this.trees = trees;
    this.link = link;
  }

  /** Why a program cannot start at a node; empty if it can. */
  public Optional<String> whyNot(ProgramDocument document, long from) {
    if (from == 0) {
      return Optional.empty();
    }
    Optional<TreeProgram> program = trees.of(document);
    if (program.isEmpty()) {
      return Optional.of(text("theProgramIsAScript"));
    }
    ProgramTree tree = program.get().tree();
    if (tree.find(from).isEmpty()) {
      return Optional.of(text("selectANodeOnTheProgram"));
    }
    return document.readOnly() && !isMain(tree, from)
        ? Optional.of(text("aProgramOfPolyscopeXRuns"))
        : PlayFrom.whyNot(tree, from);
  }

  /** Why the program in front cannot start at a node; empty if it can. */
  public Optional<String> whyNot(long selected) {
    Optional<TreeProgram> program = trees.current();
    if (program.isEmpty()) {
      return Optional.of(text("theProgramIsAScript"));
    }
    return selected == 0
        ? Optional.of(text("selectANodeOnTheProgram"))
        : whyNot(program.get().document(), selected);
  }

  /** Where a run would have the arm go first; empty for scripts, and where that is not known. */
  public Optional<FirstWaypoint.Target> first(ProgramDocument document, long from) {
    return trees
        .of(document)
        .filter(program -> whyNot(document, from).isEmpty())
        .map(program -> from == 0 ? program.tree() : PlayFrom.from(program.tree(), from))
        .flatMap(FirstWaypoint::of);
  }

  /**
   * What to run. The script of a tree must be that of the tree as it is, see {@link
   * TreeProgram#whenChecked}.
   *
   * @throws IllegalArgumentException if {@link #whyNot} has a reason
   */
  public ProgramLaunch plan(ProgramDocument document, long from) {
    Source shown = document.script().source();
    String text = document.script().text();
    Optional<TreeProgram> program = trees.of(document);
    if (program.isEmpty()) {
      return ProgramLaunch.of(RunScript.whole(shown));
    }
    ProgramTree tree = program.get().tree();
    GeneratedScript whole = program.get().script();
    boolean all = from == 0 || isMain(tree, from);
    int waiting = ExternalControl.count(tree);
    if (all && waiting == 0) {
      return ProgramLaunch.of(
          new RunScript(shown, text, RunLines.SAME, TurnLine.of(tree, whole), 0, whole.names()));
    }
    String name = program.get().programName();
    Installation installation = program.get().installation();
    return new ProgramLaunch(
        waiting,
        installation,
        sent -> {
          GeneratedScript run =
              all
                  ? ScriptGenerator.generate(name, tree, installation, sent)
                  : ScriptGenerator.generateFrom(name, tree, from, installation, sent);
          return new RunScript(
              Source.of(shown.name(), run.text()),
              text,
              RunLines.between(run, whole, sent),
              TurnLine.of(tree, run),
              all ? 0 : 1,
              run.names());
        });
  }

  private static boolean isMain(ProgramTree tree, long key) {
    return tree.find(key).filter(each -> each.step() instanceof Section.MainProgram).isPresent();
  }

  /** The node that the program that was started last is at; empty for scripts. */
  public Optional<RunNode> now(Optional<ProgramDocument> started, ControllerState state) {
    return started.flatMap(trees::of).flatMap(each -> node(each, link.at(each, state)));
  }

  /** The node of a line of the present script of a program; empty for scripts. */
  public Optional<RunNode> node(Optional<ProgramDocument> document, int line) {
    return document
        .flatMap(trees::of)
        .flatMap(each -> node(each, ScriptLink.key(each.script(), line)));
  }

  private static Optional<RunNode> node(TreeProgram program, long key) {
    return program
        .tree()
        .find(key)
        .map(node -> NodeLabels.shown(node.step()))
        .flatMap(
            label ->
                program
                    .script()
                    .of(key)
                    .map(place -> new RunNode(program.document(), key, place.number(), label)));
  }
}
