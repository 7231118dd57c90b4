package org.pendant.language.check;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import org.pendant.language.signature.Type;
import org.pendant.language.syntax.Expression;
import org.pendant.language.syntax.Statement;

final class ValueTypesTest {

  @Test
  void aVariableHasTheTypeOfAllItsAssignments() {
    assertEquals(Type.LIST, global("x = [1]\nx = [2]", "x"));
    assertEquals(Type.MATRIX, global("x = [[1]]", "x"));
    assertEquals(Type.STRUCT, global("x = struct(a=1)", "x"));
    assertEquals(Type.POSE, global("x = get_target_tcp_pose()", "x"));
    assertEquals(Type.ANY, global("if 1:\n x = 1\nelse:\n x = \"a\"\nend", "x"));
    assertEquals(Type.ANY, global("x = 1", "y"));
  }

  @Test
  void anExpressionHasTheTypeOfItsValue() {
    ProgramForm form =
        ProgramForm.of(Checks.parse("def prog():\n  x = 1\n  y = x\n  z = not x\nend"));
    Scopes scopes = Scopes.of(form);
    ValueTypes types = ValueTypes.of(form, scopes, new SmallCatalogue());
    assertEquals(Type.NUMBER, types.expression(value(form, 1), scopes.mainScope()));
    assertEquals(Type.BOOL, types.expression(value(form, 2), scopes.mainScope()));
  }

  private static Expression value(ProgramForm form, int statement) {
    return ((Statement.Assign) form.body().get(statement)).value();
  }

  private static Type global(String body, String name) {
    ProgramForm form = ProgramForm.of(Checks.parse("def prog():\n" + body + "\nend\n"));
    Scopes scopes = Scopes.of(form);
    return ValueTypes.of(form, scopes, new SmallCatalogue())
        .variable(scopes.mainScope(), new Binding.Global(name));
  }
}
