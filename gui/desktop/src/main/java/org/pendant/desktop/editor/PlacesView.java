package org.pendant.desktop.editor;

import static org.pendant.desktop.editor.EditorTexts.text;

import java.awt.BorderLayout;
import java.awt.EventQueue;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTextField;
import net.miginfocom.swing.MigLayout;
import org.pendant.desktop.editor.text.FileSearch;
import org.pendant.desktop.editor.text.Place;
import org.pendant.desktop.editor.text.SearchQuery;
import org.pendant.desktop.workbench.View;
import org.pendant.desktop.workbench.Workbench;
import org.pendant.kit.action.Action;
import org.pendant.kit.background.WorkQueue;
import org.pendant.kit.background.WorkerThread;
import org.pendant.kit.text.Messages;
import org.pendant.kit.theme.Palette;

/**
 * Places view: finds text in all scripts of a folder, or lists places that others have found, and
 * then without what is typed for a search.
 */
public final class PlacesView implements View {
  /** Its name in settings and commands. */
  public static final String ID = "search";

  private static final String FOLDER = "search.folder";
  private static final String NOTE = text("typeWhatToFindInAll");
  private static final int SHOWN_AT_ONCE = 100;
  private static final int TOLD_EVERY = 50;

  private final Workbench workbench;
  private final ScriptEditor editor;
  private final WorkQueue worker = new WorkerThread("find-in-files");
  private final JTextField words = field("search-words", text("findInFiles"));
  private final JTextField folder = field("search-folder", text("folderToLookIn"));
  private final JCheckBox matchCase = box("match-case", text("matchCase"));
  private final JCheckBox wholeWord = box("whole-words", text("wholeWords"));
  private final JCheckBox regex = box("regular-expression", text("regularExpression"));
  private final JButton start = new JButton(text("find"));
  private final JLabel summary = new JLabel(" ");
  private final JLabel title = new JLabel();
  private final JPanel form = bar();
  private final JPanel foundBar = foundBar();
  private final PlacesTable table;
  private final EmptyState states;
  private final JPanel content = new JPanel(new BorderLayout());
  private AtomicBoolean cancelled = new AtomicBoolean(true);
  private int searches;

  /** A list for {@code editor}; it adds the action that opens it. */
  public PlacesView(Workbench workbench, ScriptEditor editor) {
    this.workbench = workbench;
    this.editor = editor;
    table = new PlacesTable(editor::show);
    states = new EmptyState(new JScrollPane(table));
    content.setName("search-panel");
    JPanel head = new JPanel(new BorderLayout());
    head.add(form, BorderLayout.NORTH);
    head.add(foundBar, BorderLayout.SOUTH);
    content.add(head, BorderLayout.NORTH);
    content.add(states);
    states.showNote(NOTE);
    editor.setPlaces(this::list);
    workbench
        .actions()
        .add(Action.of("editor.find-in-files", text("findInFiles"), "control shift F", this::open));
  }

  private JPanel bar() {
    JPanel bar = new JPanel(new MigLayout("insets 6 12 6 12, gap 6, fillx", "[][grow][]"));
    JLabel find = new JLabel(text("find"));
    find.setLabelFor(words);
    JLabel in = new JLabel(text("inFolder"));
    in.setLabelFor(folder);
    start.setName("search-start");
    start.setToolTipText(text("lookThroughAllScriptsOfThe"));
    start.addActionListener(event -> startOrCancel());
    words.addActionListener(event -> find());
    folder.addActionListener(event -> find());
    summary.setName("search-summary");
    bar.add(find);
    bar.add(words, "growx");
    bar.add(start, "sg button, wrap");
    bar.add(in);
    bar.add(folder, "growx, span 2, wrap");
    bar.add(matchCase, "skip, span 2, split 4");
    bar.add(wholeWord);
    bar.add(regex);
    bar.add(summary, "growx, pushx, wmin 0, gapleft 16");
    return bar;
  }

  /** Stands above places that others have found. */
  private JPanel foundBar() {
    JPanel bar = new JPanel(new MigLayout("insets 6 12 6 12, gap 6, fillx", "[grow, 0::][]"));
    title.setName("places-title");
    JButton search = new JButton(text("findInFilesMenu"));
    search.setName("places-search");
    search.putClientProperty("JButton.buttonType", "toolBarButton");
    search.setToolTipText(text("showsTheFormThatFindsText"));
    search.addActionListener(event -> open());
    bar.add(title, "growx, wmin 0");
    bar.add(search);
    bar.setVisible(false);
    return bar;
  }

  private void showForm(boolean wanted) {
    form.setVisible(wanted);
    foundBar.setVisible(!wanted);
  }

  @Override
  public String id() {
    return ID;
  }

  @Override
  public String title() {
    return text("searchResults");
  }

  @Override
  public JComponent component() {
    return content;
  }

  /** Comes to the front, ready to type what to find. */
  private void open() {
    workbench.show(ID);
    if (!form.isVisible()) {
      // What was listed belongs to another question.
      table.set(List.of());
      summary.setText(" ");
      states.showNote(NOTE);
      showForm(true);
    }
    String selected = editor.current().area().getSelectedText();
    if (selected != null && !selected.contains("\n")) {
      words.setText(selected);
    }
    if (folder.getText().isBlank()) {
      folder.setText(usualFolder());
    }
    words.selectAll();
    words.requestFocusInWindow();
  }

  private String usualFolder() {
    return editor
        .programs()
        .current()
        .file()
        .map(file -> file.toAbsolutePath().getParent().toString())
        .or(() -> workbench.settings().get(FOLDER))
        .orElse(System.getProperty("user.home"));
  }

  /** Shows places that another view has found. */
  private void list(String heading, List<Place> places) {
    cancel();
    title.setText(heading);
    title.setToolTipText(heading);
    showForm(false);
    table.set(places);
    states.showContent();
    EventQueue.invokeLater(table::requestFocusInWindow);
  }

  private void startOrCancel() {
    if (cancelled.get()) {
      find();
    } else {
      cancel();
    }
  }

  private void cancel() {
    cancelled.set(true);
    start.setText(text("find"));
  }

  private void find() {
    cancel();
    SearchQuery query =
        new SearchQuery(
            words.getText(), matchCase.isSelected(), wholeWord.isSelected(), regex.isSelected());
    if (words.getText().isEmpty()) {
      refuse(words, text("nothingToFindTypeSomeWords"));
      return;
    }
    if (!query.complaint().isEmpty()) {
      refuse(words, text("regularExpressionIsWrong", query.complaint()));
      return;
    }
    Path where = folder();
    words.putClientProperty("JComponent.outline", null);
    folder.putClientProperty("JComponent.outline", null);
    workbench.settings().put(FOLDER, where.toString());
    AtomicBoolean stop = new AtomicBoolean();
    cancelled = stop;
    start.setText(text("cancel"));
    table.set(List.of());
    states.showContent();
    summary.setForeground(Palette.quiet());
    summary.setText(text("looking"));
    int number = ++searches;
    worker.run(0, () -> search(new FileSearch(where, query), stop, number));
  }

  private Path folder() {
    try {
      return Path.of(folder.getText().strip());
    } catch (InvalidPathException e) {
      return Path.of("");
    }
  }

  private void refuse(JTextField field, String reason) {
    field.putClientProperty("JComponent.outline", "error");
    field.requestFocusInWindow();
    summary.setForeground(Palette.error());
    summary.setText(reason);
  }

  /** On the worker thread. */
  private void search(FileSearch search, AtomicBoolean stop, int number) {
    if (!Files.isDirectory(search.folder())) {
      EventQueue.invokeLater(
          () -> {
            cancel();
            refuse(folder, text("isNotAFolder", search.folder()));
          });
      return;
    }
    List<Place> found = new ArrayList<>();
    try {
      FileSearch.Summary result =
          search.run(
              place -> {
                found.add(place);
                if (found.size() == SHOWN_AT_ONCE) {
                  show(found, stop);
                }
              },
              (done, all) -> tellProgress(done, all, stop),
              stop::get);
      show(found, stop);
      EventQueue.invokeLater(() -> finish(result, stop, number));
    } catch (IOException e) {
      EventQueue.invokeLater(() -> refuse(folder, text("notSearched", e)));
    }
  }

  private void tellProgress(int done, int all, AtomicBoolean stop) {
    if (done % TOLD_EVERY == 0) {
      EventQueue.invokeLater(
          () -> {
            if (!stop.get()) {
              summary.setText(text("lookingOfScripts", done, all));
            }
          });
    }
  }

  private void show(List<Place> found, AtomicBoolean stop) {
    List<Place> more = List.copyOf(found);
    found.clear();
    EventQueue.invokeLater(
        () -> {
          if (!stop.get()) {
            table.add(more);
          }
        });
  }

  private void finish(FileSearch.Summary result, AtomicBoolean stop, int number) {
    if (number != searches) {
      return; // another search has begun
    }
    String found = Messages.shown(result.sentence());
    String told =
        stop.get()
            ? text("cancelled", found)
            : result.complete() ? found : text("thereAreMore", found);
    cancel();
    summary.setText(told);
    if (result.places() == 0) {
      states.showNote(text("nothingFound", result.sentence()));
    }
  }

  private static JTextField field(String name, String accessible) {
    JTextField field = new JTextField();
    field.setName(name);
    field.setToolTipText(accessible);
    field.getAccessibleContext().setAccessibleName(accessible);
    return field;
  }

  private static JCheckBox box(String name, String title) {
    JCheckBox box = new JCheckBox(title);
    box.setName("search-" + name);
    box.setToolTipText(title);
    return box;
  }
}
