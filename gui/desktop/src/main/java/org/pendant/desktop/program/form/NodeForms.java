package org.pendant.desktop.program.form;

import static org.pendant.desktop.program.form.FormTexts.text;

import java.awt.Component;
import java.awt.Container;
import java.awt.EventQueue;
import java.awt.KeyboardFocusManager;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.function.Supplier;
import java.util.stream.Stream;
import javax.swing.JComponent;
import javax.swing.JScrollPane;
import javax.swing.SwingUtilities;
import org.pendant.desktop.debug.ConditionCheck;
import org.pendant.desktop.workbench.Workbench;
import org.pendant.kit.background.WorkQueue;
import org.pendant.kit.background.WorkerThread;
import org.pendant.kit.layout.SettledScroll;
import org.pendant.kit.layout.TitledCard;
import org.pendant.kit.text.Messages;
import org.pendant.language.signature.Catalogue;
import org.pendant.project.program.ProgramNode;

/**
 * Node forms: the form of the selected node. What is typed changes the program at once, by {@link
 * FormHost#change}; what cannot be taken stays red in its field. Controls are named {@code
 * form-<kind>-<field>}. Only the dispatch thread calls it.
 */
public final class NodeForms {
  private static final String NOTHING = text("nothingIsSelected");
  private static final String HOW = text("chooseANodeOfTheProgram");

  private final FormPresenter presenter;
  private final Supplier<ConditionCheck> checks;
  private final Catalogue catalogue;
  private final FormSheet sheet = new FormSheet();
  private final JScrollPane scroll = new SettledScroll(sheet);
  private final FormHeader header;
  private Map<String, Shown> views = new LinkedHashMap<>();
  private List<String> shape = List.of();
  private OptionalLong shownKey = OptionalLong.empty();
  private boolean renderAsked;

  /** A control and what it was made for. */
  private record Shown(String shape, FieldView view) {}

  /** Forms of the program of {@code host}; nothing is selected. */
  public NodeForms(Workbench workbench, FormHost host) {
    assert EventQueue.isDispatchThread();
    WorkQueue background = new WorkerThread("program-forms");
    presenter = new FormPresenter(host, new DesktopFiles(scroll, background, host));
    catalogue = workbench.session().robot().builtins();
    checks =
        () ->
            new ConditionCheck(
                background, EventQueue::invokeLater, catalogue, () -> presenter.scope().source());
    header =
        new FormHeader(
            () -> {
              presenter.useAgain();
              renderLater();
            });
    scroll.setName("node-form");
    scroll.getAccessibleContext().setAccessibleName(text("whatTheSelectedNodeDoes"));
    scroll.setHorizontalScrollBarPolicy(JScrollPane.HORIZONTAL_SCROLLBAR_NEVER);
    render();
  }

  /** What is shown; the same component always. */
  public JComponent component() {
    return scroll;
  }

  /**
   * Shows the form of a node as it is now; also to be called when the program, the installation or
   * the problems have changed.
   *
   * @param node of the program; empty if none or several are selected
   */
  public void show(Optional<ProgramNode> node) {
    presenter.select(node);
    if (shownKey.isEmpty()) {
      render();
    } else {
      // The user may be typing in the form: it changes when that is done.
      renderLater();
    }
  }

  /** Puts the keyboard into the field that a problem of the shown node is about. */
  public void focus(String field) {
    render();
    presenter
        .form()
        .flatMap(form -> form.itemFor(field).or(form::firstField))
        .flatMap(item -> control(item.name()))
        .ifPresent(
            control -> {
              control.requestFocusInWindow();
              if (control.getParent() instanceof JComponent around) {
                around.scrollRectToVisible(control.getBounds());
              }
            });
  }

  private Optional<JComponent> control(String name) {
    Shown shown = views.get(name);
    if (shown != null) {
      return Optional.of(shown.view().focus());
    }
    return views.values().stream()
        .map(Shown::view)
        .flatMap(
            view ->
                view instanceof GridView grid
                    ? grid.field(name).stream()
                    : Stream.<JComponent>empty())
        .findFirst();
  }

  private void renderLater() {
    if (!renderAsked) {
      renderAsked = true;
      EventQueue.invokeLater(
          () -> {
            renderAsked = false;
            render();
          });
    }
  }

  private void render() {
    Optional<NodeForm> form = presenter.form();
    List<String> wanted = form.map(NodeForm::shape).orElse(List.of());
    boolean sameNode = presenter.key().equals(shownKey);
    boolean other = !sameNode || !wanted.equals(shape) || sheet.getComponentCount() == 0;
    if (other) {
      boolean sameKind =
          sameNode
              && !wanted.isEmpty()
              && !shape.isEmpty()
              && wanted.getFirst().equals(shape.getFirst());
      if (!sameNode) {
        header.giveRoomBack();
      }
      rebuild(form, sameKind);
      shape = wanted;
      shownKey = presenter.key();
    }
    header.setSuppressed(presenter.suppressed());
    form.ifPresent(
        shown -> {
          header.show(shown.title(), shown.about());
          shown.items().forEach(this::update);
        });
    if (form.isEmpty()) {
      header.show(NOTHING, HOW);
    }
    showProblems();
  }

  private void update(Item item) {
    Shown shown = views.get(item.name());
    if (shown != null) {
      shown.view().show(item);
    }
  }

  /**
   * What is wrong, found by the check of the program or typed just now, and what the script is
   * warned of: the mark in the tree tells it to the pointer alone.
   */
  private void showProblems() {
    Optional<NodeForm> form = presenter.form();
    header.setProblems(form.map(presenter::problems).orElse(List.of()));
    header.setWarnings(presenter.warnings());
    form.ifPresent(
        shown ->
            views.forEach(
                (name, each) -> each.view().setProblem(problem(shown, name, each.view()))));
  }

  /** At an item, or at a number in it. */
  private String problem(NodeForm form, String name, FieldView view) {
    if (view instanceof GridView && form.item(name).orElseThrow() instanceof Item.Grid grid) {
      for (Item.Quantity number : grid.numbers()) {
        String problem = presenter.problem(form, number.name());
        if (!problem.isEmpty()) {
          return Messages.told(number.label(), problem);
        }
      }
    }
    return presenter.problem(form, name);
  }

  /**
   * Other controls, as far as those that there are do not fit; a user who types continues typing.
   */
  private void rebuild(Optional<NodeForm> form, boolean sameKind) {
    Component focused = KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner();
    boolean inside = focused != null && SwingUtilities.isDescendingFrom(focused, sheet);
    Map<String, Shown> before = sameKind ? views : Map.of();
    views = new LinkedHashMap<>();
    sheet.removeAll();
    sheet.add(header);
    form.ifPresent(shown -> addParts(shown, new HashMap<>(before)));
    sheet.revalidate();
    sheet.repaint();
    if (!sameKind) {
      EventQueue.invokeLater(() -> scroll.getVerticalScrollBar().setValue(0));
    }
    if (inside) {
      Component again =
          SwingUtilities.isDescendingFrom(focused, sheet)
              ? focused
              : named(sheet, focused.getName());
      if (again != null) {
        again.requestFocusInWindow();
      }
    }
  }

  private static Component named(Container in, String name) {
    for (Component each : in.getComponents()) {
      if (name != null && name.equals(each.getName())) {
        return each;
      }
      if (each instanceof Container inner) {
        Component found = named(inner, name);
        if (found != null) {
          return found;
        }
      }
    }
    return null;
  }

  private void addParts(NodeForm form, Map<String, Shown> before) {
    FieldViews maker =
        new FieldViews(
            presenter, checks, catalogue, form.kind(), this::showProblems, this::renderLater);
    for (NodeForm.Part part : form.parts()) {
      String title = part.title().isEmpty() ? text("settings") : part.title();
      TitledCard card =
          new TitledCard(
              part.title().isEmpty() ? "settings" : part.items().getFirst().name(),
              title,
              "[][grow, fill]");
      for (Item item : part.items()) {
        Shown old = before.remove(item.name());
        FieldView view =
            old != null && old.shape().equals(NodeForm.shapeOf(item))
                ? old.view()
                : maker.view(item);
        views.put(item.name(), new Shown(NodeForm.shapeOf(item), view));
        if (view instanceof LineView line && item instanceof Item.Line items) {
          for (int i = 0; i < items.items().size(); i++) {
            Item inner = items.items().get(i);
            views.put(inner.name(), new Shown(NodeForm.shapeOf(inner), line.views().get(i)));
          }
        }
        add(card, item, view);
      }
      sheet.add(card, "wmin 0");
    }
  }

  private static void add(TitledCard card, Item item, FieldView view) {
    switch (item) {
      case Item.Quantity _,
          Item.Text _,
          Item.Expression _,
          Item.Choice _,
          Item.Presses _,
          Item.Line _ -> {
        Optional<JComponent> lead = view instanceof LineView line ? line.lead() : Optional.empty();
        if (lead.isPresent()) {
          card.add(lead.get(), "aligny top, hmin " + view.component().getPreferredSize().height);
          card.add(view.component(), "growx, wmin 0");
        } else if (item.label().isEmpty()) {
          card.add(view.component(), "span, growx, wmin 0");
        } else {
          card.add(new FormLabel(item.label(), view.focus()), "aligny top");
          card.add(view.component(), "growx, wmin 0");
        }
      }
      case Item.Prose _, Item.Code _, Item.Grid _ -> {
        if (!item.label().isEmpty()) {
          card.add(new FormLabel(item.label(), view.focus()), "span, wmin 0");
        }
        card.add(view.component(), "span, growx, wmin 0");
      }
      case Item.Check _, Item.Drawing _ -> card.add(view.component(), "span, growx, wmin 0");
      case Item.Note _ -> card.add(view.component(), "span, growx, width 0:10:");
    }
  }
}
