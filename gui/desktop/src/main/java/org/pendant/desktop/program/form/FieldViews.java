package org.pendant.desktop.program.form;

import java.util.Locale;
import java.util.function.Supplier;
import javax.swing.JComponent;
import org.pendant.desktop.debug.ConditionCheck;
import org.pendant.language.signature.Catalogue;

/**
 * Field view factory: makes the controls of a form.
 *
 * @param presenter takes what people do
 * @param checks makes what reads one expression while it is typed
 * @param catalogue the functions of the language
 * @param kind of the node, for the names of controls
 * @param refused told when what is wrong with a field changes
 * @param done told after something has been chosen or pressed
 */
record FieldViews(
    FormPresenter presenter,
    Supplier<ConditionCheck> checks,
    Catalogue catalogue,
    String kind,
    Runnable refused,
    Runnable done) {

  /** The control for an item; nothing is shown in it yet. */
  FieldView view(Item item) {
    return switch (item) {
      case Item.Quantity number -> new NumberView(this, number, true);
      case Item.Text text -> new TextView(this, text);
      case Item.Expression expression -> new ExpressionView(this, expression);
      case Item.Prose prose -> new ProseView(this, prose);
      case Item.Code code -> code.script() ? new ScriptView(this, code) : new PlainView(this, code);
      case Item.Choice choice ->
          choice.side() ? new SidesView(this, choice) : new ChoiceView(this, choice);
      case Item.Check each -> new CheckView(this, each);
      case Item.Presses presses -> new PressesView(this, presses, true);
      case Item.Note note -> new NoteView(this, note);
      case Item.Drawing drawing -> new SketchView(id(drawing.name()));
      case Item.Grid grid -> new GridView(this, grid);
      case Item.Line line -> new LineView(this, line);
    };
  }

  /** The name of the control of an item. */
  String id(String name) {
    return "form-" + kind + "-" + name;
  }

  /** Names a control for tests and screen readers. */
  <C extends JComponent> C named(C control, Item item) {
    control.setName(id(item.name()));
    String words = item.label().isEmpty() ? item.name() : item.label();
    control
        .getAccessibleContext()
        .setAccessibleName(words.substring(0, 1).toUpperCase(Locale.ROOT) + words.substring(1));
    return control;
  }

  /** Shows what is wrong with a control to those who hear it. */
  static void describe(JComponent control, String problem, String tip) {
    String said = problem.isEmpty() ? tip : problem;
    control.setToolTipText(said.isEmpty() ? null : said);
    control.getAccessibleContext().setAccessibleDescription(said);
  }
}
