package org.pendant.desktop.program.form;

import static org.pendant.desktop.program.form.FormTexts.text;

import javax.swing.JComponent;
import org.pendant.desktop.debug.ConditionCheck;
import org.pendant.desktop.debug.FieldCompletions;
import org.pendant.kit.layout.Typed;

/** Expression view: an expression, read while it is typed, completed by CTRL SPACE. */
final class ExpressionView implements FieldView {
  private static final int COLUMNS = 14;

  private final FieldViews views;
  private final TypedField field;
  private final FieldPanel panel;
  private final FieldCompletions completions;
  private final ConditionCheck check;
  private Item.Expression item;
  private ExpressionScope scope = ExpressionScope.NONE;
  private String live = "";
  private String found = "";

  ExpressionView(FieldViews views, Item.Expression expression) {
    this.views = views;
    check = views.checks().get();
    item = expression;
    field =
        new TypedField(
            COLUMNS,
            typed -> views.presenter().typeText(item.name(), typed),
            String::strip,
            views.refused());
    field.putClientProperty("FlatLaf.styleClass", "monospaced");
    views.named(field, expression);
    completions = new FieldCompletions(field, this::complete);
    panel = new FieldPanel(field, field.getName(), () -> live);
    field.getDocument().addDocumentListener(new Typed(this::read));
    show(expression);
  }

  /** What stands before an expression that may have any value, to make a condition of it. */
  private String before() {
    return item.condition() ? "" : ExpressionScope.ANYTHING + " == (";
  }

  private String whole(String text) {
    return item.condition() || text.isBlank() ? text : before() + text + ")";
  }

  private void read() {
    String text = field.getText();
    scope = views.presenter().scope();
    check.check(
        scope.line(),
        whole(text),
        refusal -> {
          if (field.getText().equals(text)) {
            live = refusal;
            setProblem(found);
          }
        });
  }

  private void complete() {
    String text = field.getText();
    int caret = field.getCaretPosition();
    check.complete(
        scope.line(),
        before() + text,
        before().length() + caret,
        offered -> {
          if (field.getText().equals(text) && field.getCaretPosition() == caret) {
            completions.offer(
                offered.stream()
                    .filter(each -> !each.insert().equals(ExpressionScope.ANYTHING))
                    .toList());
          }
        });
  }

  @Override
  public JComponent component() {
    return panel;
  }

  @Override
  public JComponent focus() {
    return field;
  }

  @Override
  public void show(Item shown) {
    item = (Item.Expression) shown;
    field.follow(item.value());
    field.putClientProperty("JTextField.placeholderText", item.hint());
    // Other nodes may have given or taken away names.
    if (!views.presenter().scope().equals(scope)) {
      read();
    }
  }

  @Override
  public void setProblem(String problem) {
    found = problem;
    String said = panel.say(problem);
    field.outline(!said.isEmpty());
    FieldViews.describe(field, said, text("anExpressionCtrlSpaceCompletes", item.hint()));
  }
}
