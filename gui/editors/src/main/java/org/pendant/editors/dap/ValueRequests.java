package org.pendant.editors.dap;

import static org.pendant.editors.dap.DebugAdapterTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import org.eclipse.lsp4j.debug.EvaluateArguments;
import org.eclipse.lsp4j.debug.EvaluateArgumentsContext;
import org.eclipse.lsp4j.debug.EvaluateResponse;
import org.eclipse.lsp4j.debug.InvalidatedAreas;
import org.eclipse.lsp4j.debug.SetExpressionArguments;
import org.eclipse.lsp4j.debug.SetExpressionResponse;
import org.eclipse.lsp4j.debug.SetVariableArguments;
import org.eclipse.lsp4j.debug.SetVariableResponse;
import org.eclipse.lsp4j.debug.Variable;
import org.eclipse.lsp4j.debug.VariablesArguments;
import org.eclipse.lsp4j.debug.VariablesArgumentsFilter;
import org.eclipse.lsp4j.debug.VariablesResponse;
import org.pendant.editors.dap.look.Branch;
import org.pendant.editors.dap.look.LiveScope;
import org.pendant.editors.dap.look.Shown;

/** Requests about values: looked at piece by piece, computed, and changed. */
final class ValueRequests {
  private final DebugSession session;
  private final DataBreakpoints data;

  ValueRequests(DebugSession session, DataBreakpoints data) {
    this.data = data;
    this.session = session;
  }

  CompletableFuture<VariablesResponse> variables(VariablesArguments asked) {
    References.Owned owned = session.references().branch(asked.getVariablesReference());
    Branch branch = owned.branch();
    VariablesArgumentsFilter filter = asked.getFilter();
    if (filter != null && (filter == VariablesArgumentsFilter.INDEXED) != branch.indexed()) {
      return CompletableFuture.completedFuture(told(List.of(), owned.frame()));
    }
    int start = Math.max(0, Objects.requireNonNullElse(asked.getStart(), 0));
    int count = Objects.requireNonNullElse(asked.getCount(), 0);
    if (count <= 0 && branch.size() > Branch.MOST && !session.paging()) {
      return CompletableFuture.completedFuture(told(pages(branch), owned.frame()));
    }
    int most = count <= 0 ? Branch.MOST : Math.min(count, Branch.MOST);
    return branch.page(start, most).thenApply(page -> told(page, owned.frame()));
  }

  /** For a client that would ask for all at once: a part for each thousand. */
  private List<Shown> pages(Branch branch) {
    List<Shown> pages = new ArrayList<>();
    for (int i = 0; i < branch.size() && pages.size() < Branch.MOST; i += Branch.MOST) {
      int first = i;
      int last = Math.min(branch.size(), first + Branch.MOST) - 1;
      Branch page =
          new Branch() {
            @Override
            public int size() {
              return last - first + 1;
            }

            @Override
            public boolean indexed() {
              return branch.indexed();
            }

            @Override
            public CompletableFuture<List<Shown>> page(int start, int count) {
              return branch.page(first + start, Math.min(count, size() - start));
            }

            @Override
            public CompletableFuture<Shown> assign(String name, String value) {
              return branch.assign(name, value);
            }
          };
      pages.add(
          new Shown(
              session.form().shown(text("page", first, last)),
              "",
              "",
              "",
              Optional.of(page),
              false));
    }
    return pages;
  }

  private VariablesResponse told(List<Shown> all, References.Frame frame) {
    VariablesResponse response = new VariablesResponse();
    response.setVariables(all.stream().map(each -> told(each, frame)).toArray(Variable[]::new));
    return response;
  }

  private Variable told(Shown shown, References.Frame frame) {
    Variable told = new Variable();
    told.setName(shown.name());
    told.setValue(shown.value(session.form()::shown));
    if (!shown.type().isEmpty()) {
      told.setType(shown.type());
    }
    if (!shown.expression().isEmpty()) {
      told.setEvaluateName(shown.expression());
    }
    Parts parts = parts(shown, frame);
    told.setVariablesReference(parts.reference());
    told.setIndexedVariables(parts.indexed());
    told.setNamedVariables(parts.named());
    return told;
  }

  /** What a client is told of the parts of a value; nulls are left out of messages. */
  private record Parts(int reference, Integer indexed, Integer named) {}

  private Parts parts(Shown shown, References.Frame frame) {
    if (shown.branch().isEmpty()) {
      return new Parts(0, null, null);
    }
    Branch branch = shown.branch().get();
    return new Parts(
        session.references().of(branch, frame),
        branch.indexed() ? branch.size() : null,
        branch.indexed() ? null : branch.size());
  }

  CompletableFuture<EvaluateResponse> evaluate(EvaluateArguments asked) {
    String expression = asked.getExpression();
    boolean hover = EvaluateArgumentsContext.HOVER.equals(asked.getContext());
    if (hover && expression.indexOf('(') >= 0) {
      return Refusals.answer(text("callsNotHovered"));
    }
    References.Frame frame = frame(asked.getFrameId());
    boolean repl = EvaluateArgumentsContext.REPL.equals(asked.getContext());
    Optional<TypedAssignment> assignment = repl ? TypedAssignment.of(expression) : Optional.empty();
    CompletableFuture<Shown> value =
        assignment.isPresent()
            ? assign(frame, assignment.get().target(), assignment.get().value())
            : evaluate(frame, expression);
    return value.thenApply(
        shown -> {
          EvaluateResponse response = new EvaluateResponse();
          response.setResult(shown.value(session.form()::shown));
          response.setType(shown.type());
          Parts parts = parts(shown, frame);
          response.setVariablesReference(parts.reference());
          response.setIndexedVariables(parts.indexed());
          response.setNamedVariables(parts.named());
          return response;
        });
  }

  /** The call that is meant; without one that of the main thread with the global variables. */
  private References.Frame frame(Integer id) {
    if (id == null || id == 0) {
      LiveScope global = LiveScope.global(session.program().run());
      return new References.Frame(global.thread(), global.depth());
    }
    return session.references().frame(id);
  }

  private CompletableFuture<Shown> evaluate(References.Frame frame, String expression) {
    return session.view().isPresent()
        ? session.stopped().evaluate(frame.thread(), frame.depth(), expression)
        : live(frame).evaluate(expression);
  }

  private CompletableFuture<Shown> assign(References.Frame frame, String target, String value) {
    return changed(
        session.view().isPresent()
            ? session.stopped().assign(frame.thread(), frame.depth(), target, value)
            : live(frame).assign(target, value));
  }

  /** Other values may have changed with it. */
  private CompletableFuture<Shown> changed(CompletableFuture<Shown> assigned) {
    return assigned.thenApply(
        shown -> {
          data.changedByHand();
          session.tellChanged(InvalidatedAreas.VARIABLES);
          return shown;
        });
  }

  private LiveScope live(References.Frame frame) {
    return new LiveScope(session.program().run(), frame.thread(), frame.depth());
  }

  CompletableFuture<SetVariableResponse> setVariable(SetVariableArguments asked) {
    References.Owned owned = session.references().branch(asked.getVariablesReference());
    return changed(owned.branch().assign(asked.getName(), asked.getValue()))
        .thenApply(
            shown -> {
              SetVariableResponse response = new SetVariableResponse();
              response.setValue(shown.value(session.form()::shown));
              response.setType(shown.type());
              Parts parts = parts(shown, owned.frame());
              response.setVariablesReference(parts.reference());
              response.setIndexedVariables(parts.indexed());
              response.setNamedVariables(parts.named());
              return response;
            });
  }

  CompletableFuture<SetExpressionResponse> setExpression(SetExpressionArguments asked) {
    References.Frame frame = frame(asked.getFrameId());
    return assign(frame, asked.getExpression(), asked.getValue())
        .thenApply(
            shown -> {
              SetExpressionResponse response = new SetExpressionResponse();
              response.setValue(shown.value(session.form()::shown));
              response.setType(shown.type());
              Parts parts = parts(shown, frame);
              response.setVariablesReference(parts.reference());
              response.setIndexedVariables(parts.indexed());
              response.setNamedVariables(parts.named());
              return response;
            });
  }
}
