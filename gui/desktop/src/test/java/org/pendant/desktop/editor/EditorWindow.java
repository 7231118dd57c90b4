package org.pendant.desktop.editor;

import java.awt.BorderLayout;
import java.awt.EventQueue;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JSplitPane;
import javax.swing.JTabbedPane;
import javax.swing.KeyStroke;
import org.pendant.controller.ControllerOptions;
import org.pendant.desktop.preview.PreviewWorkbench;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.Programs;
import org.pendant.desktop.session.RobotSession;
import org.pendant.desktop.session.SavedProgram;
import org.pendant.kit.action.Action;
import org.pendant.kit.theme.PreviewLook;

/** The script editor with its panels in a window of its own, for trying it by hand. */
public final class EditorWindow extends PreviewWorkbench {
  private final JLabel status = new JLabel(" ");
  private final JTabbedPane panels = new JTabbedPane();
  private final JFrame frame = new JFrame("Script");
  private final Programs programs;
  private ScriptEditor editor;

  private EditorWindow(ProgramDocument first) {
    super(RobotSession.start(ControllerOptions.headless()));
    programs = new Programs(first);
  }

  /** Opens the window. Arguments: {@code light} or {@code dark}, then files. */
  public static void main(String[] args) throws IOException {
    List<ProgramDocument> documents = new ArrayList<>();
    for (int i = 1; i < args.length; i++) {
      documents.add(ProgramDocument.of(SavedProgram.read(Path.of(args[i]))));
    }
    if (documents.isEmpty()) {
      documents.add(ProgramDocument.untitled("untitled.script", ""));
    }
    EventQueue.invokeLater(() -> open(args.length > 0 && args[0].equals("dark"), documents));
  }

  /** Opens a window on {@code documents}, the first in front. */
  static EditorWindow open(boolean dark, List<ProgramDocument> documents) {
    EditorWindow window = begin(dark, documents, documents.getFirst());
    window.editor.openBehind();
    return window;
  }

  /** Opens a window on {@code documents} in which only {@code front} has an editor yet. */
  static EditorWindow begin(boolean dark, List<ProgramDocument> documents, ProgramDocument front) {
    PreviewLook.install(dark);
    EditorWindow window = new EditorWindow(documents.getFirst());
    documents.forEach(window.programs::open);
    window.programs.select(front);
    window.build();
    return window;
  }

  private void build() {
    editor = new ScriptEditor(this, programs);
    OutlineView outline = new OutlineView(this, editor);
    panels.addTab("Problems", new ProblemsView(this, editor).component());
    panels.addTab("Search results", new PlacesView(this, editor).component());
    JSplitPane bottom = new JSplitPane(JSplitPane.VERTICAL_SPLIT, editor.component(), panels);
    bottom.setResizeWeight(0.75);
    JSplitPane all = new JSplitPane(JSplitPane.HORIZONTAL_SPLIT, bottom, outline.component());
    all.setResizeWeight(0.8);
    frame.add(all);
    frame.add(status, BorderLayout.SOUTH);
    for (Action action : actions().all()) {
      KeyStroke keys = KeyStroke.getKeyStroke(action.keys());
      frame
          .getRootPane()
          .registerKeyboardAction(
              event -> run(action.id()), keys, JComponent.WHEN_IN_FOCUSED_WINDOW);
    }
    frame.setDefaultCloseOperation(JFrame.EXIT_ON_CLOSE);
    String size = System.getProperty("size", "1440x900");
    String[] sides = size.split("x", 2);
    frame.setSize(Integer.parseInt(sides[0]), Integer.parseInt(sides[1]));
    frame.setVisible(true);
    bottom.setDividerLocation(0.72);
    all.setDividerLocation(0.8);
    editor.current().area().requestFocusInWindow();
  }

  ScriptEditor editor() {
    return editor;
  }

  JFrame frame() {
    return frame;
  }

  void close() {
    frame.dispose();
    session().close();
  }

  @Override
  public void show(String viewId) {
    if (viewId.equals(ProblemsView.ID)) {
      panels.setSelectedIndex(0);
    } else if (viewId.equals(PlacesView.ID)) {
      panels.setSelectedIndex(1);
    }
  }

  @Override
  public void showSource(int line, int column) {
    editor.show(line, column);
  }

  @Override
  public void notify(String text) {
    status.setText(text);
  }
}
