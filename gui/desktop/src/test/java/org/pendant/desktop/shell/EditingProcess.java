package org.pendant.desktop.shell;

import java.awt.EventQueue;
import java.io.IOException;
import java.io.PrintStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Random;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import javax.swing.Timer;
import org.pendant.desktop.program.TreeProgram;
import org.pendant.desktop.program.TreePrograms;
import org.pendant.desktop.session.ActiveInstallation;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.Programs;
import org.pendant.desktop.session.RecoveryFolder;
import org.pendant.desktop.session.SavedProgram;
import org.pendant.desktop.session.SceneDraft;
import org.pendant.kit.background.Background;
import org.pendant.project.program.ActionStep;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.ProgramTree;

/**
 * A process that edits program trees without a window, with what the desktop keeps against a crash:
 * one program with a file, which it saves now and then, and one without. After each edit it writes
 * a line of standard output: the name of the program and when the edit was made, ms since 1970. The
 * first comment of the program says when as well.
 */
final class EditingProcess {
  /** Name of the program without a file. */
  static final String UNTITLED = "untitled.pendant";

  private static final int EDIT_MS = 20;
  private static final int SAVE_EVERY = 60;
  private static final int MAX_NODES = 300;

  private final Random random;
  private final PrintStream out = new PrintStream(System.out, true, StandardCharsets.UTF_8);
  private final Programs programs;
  private final TreePrograms trees;
  private final Autosave autosave;
  private int edits;

  private EditingProcess(Path file, Path kept, long seed) throws IOException {
    random = new Random(seed);
    ActiveInstallation installation = new ActiveInstallation();
    programs = new Programs(ProgramDocument.of(SavedProgram.read(file)));
    programs.select(ProgramDocument.untitled(UNTITLED, ""));
    // it ends with the process
    ExecutorService worker =
        Executors.newSingleThreadExecutor(Thread.ofPlatform().daemon().factory());
    trees = new TreePrograms(programs, installation, worker, EventQueue::invokeLater);
    autosave =
        new Autosave(
            programs,
            installation,
            new SceneDraft(),
            new RecoveryFolder(kept),
            new Notices(),
            text -> out.println("told " + text));
  }

  /**
   * Edits until it is killed, or nobody holds its standard input any more.
   *
   * @param arguments the file of a program, the folder for what is kept, and a seed
   */
  public static void main(String[] arguments) throws IOException {
    EditingProcess process =
        new EditingProcess(
            Path.of(arguments[0]), Path.of(arguments[1]), Long.parseLong(arguments[2]));
    EventQueue.invokeLater(process::begin);
    int more = System.in.read();
    Runtime.getRuntime().halt(more < 0 ? 0 : 1);
  }

  private void begin() {
    new Timer(DesktopWindow.KEEP_MS, event -> autosave.look()).start();
    new Timer(EDIT_MS, event -> edit()).start();
  }

  private void edit() {
    ProgramDocument document = programs.all().get(random.nextInt(2));
    TreeProgram program = trees.of(document).orElseThrow();
    long now = System.currentTimeMillis();
    ProgramTree tree = program.tree();
    List<ProgramNode> nodes = tree.nodes();
    long main = tree.sections().getFirst().key();
    ProgramTree next =
        nodes.size() < 2
            ? tree.insert(main, 0, List.of(stamp(now)))
            : other(tree, main, nodes).withStep(nodes.get(1).key(), stamp(now).step());
    program.change("Edit", nodes.getLast().key(), next);
    out.println(document.name() + " " + now);
    edits++;
    if (edits % SAVE_EVERY == 0) {
      document.toSave().ifPresent(file -> save(document, file));
    }
  }

  private static ProgramNode stamp(long now) {
    return ProgramTree.node(new ActionStep.Comment("at " + now));
  }

  /** One node more or less. */
  private ProgramTree other(ProgramTree tree, long main, List<ProgramNode> nodes) {
    if (nodes.size() < MAX_NODES && random.nextInt(3) > 0) {
      ProgramNode folder = ProgramTree.node(new ActionStep.Folder("Part " + edits));
      return tree.insert(main, tree.childrenOf(main).size(), List.of(folder));
    }
    int index = random.nextInt(nodes.size());
    return index < 2 ? tree : tree.remove(List.of(nodes.get(index).key()));
  }

  /** As the desktop saves. */
  private static void save(ProgramDocument document, SavedProgram file) {
    Background.run(
        () -> {
          file.write();
          return file;
        },
        document::saved,
        failed -> {
          throw new UncheckedIOException(failed);
        });
  }
}
