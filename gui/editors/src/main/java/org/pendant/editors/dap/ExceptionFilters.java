package org.pendant.editors.dap;

import static org.pendant.editors.dap.DebugAdapterTexts.text;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import java.util.stream.Stream;
import org.eclipse.lsp4j.debug.Breakpoint;
import org.eclipse.lsp4j.debug.BreakpointNotVerifiedReason;
import org.eclipse.lsp4j.debug.ExceptionBreakpointsFilter;
import org.eclipse.lsp4j.debug.ExceptionFilterOptions;
import org.eclipse.lsp4j.debug.SetExceptionBreakpointsArguments;
import org.eclipse.lsp4j.debug.SetExceptionBreakpointsResponse;

/** Exception filters: which failures stop a program before it ends. */
final class ExceptionFilters {
  private static final String ERROR = "error";
  private static final String SAFETY = "safetyStop";

  private final DebugSession session;
  private final Set<String> wanted = new HashSet<>();

  ExceptionFilters(DebugSession session) {
    this.session = session;
  }

  /** What a client can choose from. */
  static ExceptionBreakpointsFilter[] all(ClientForm form) {
    return new ExceptionBreakpointsFilter[] {
      filter(ERROR, form.shown(text("runtimeErrors")), form.shown(text("runtimeErrorsTip"))),
      filter(SAFETY, form.shown(text("protectiveStops")), form.shown(text("protectiveStopsTip"))),
    };
  }

  private static ExceptionBreakpointsFilter filter(String id, String label, String description) {
    ExceptionBreakpointsFilter filter = new ExceptionBreakpointsFilter();
    filter.setFilter(id);
    filter.setLabel(label);
    filter.setDescription(description);
    filter.setDefault_(true);
    return filter;
  }

  SetExceptionBreakpointsResponse set(SetExceptionBreakpointsArguments asked) {
    List<String> names = new ArrayList<>();
    String[] plain = Objects.requireNonNullElse(asked.getFilters(), new String[0]);
    ExceptionFilterOptions[] options =
        Objects.requireNonNullElse(asked.getFilterOptions(), new ExceptionFilterOptions[0]);
    Stream.concat(Stream.of(plain), Stream.of(options).map(ExceptionFilterOptions::getFilterId))
        .forEach(names::add);
    wanted.clear();
    wanted.addAll(names);
    apply();
    SetExceptionBreakpointsResponse response = new SetExceptionBreakpointsResponse();
    response.setBreakpoints(names.stream().map(this::told).toArray(Breakpoint[]::new));
    return response;
  }

  private Breakpoint told(String name) {
    Breakpoint told = new Breakpoint();
    told.setVerified(true);
    if (!name.equals(ERROR) && !name.equals(SAFETY)) {
      BreakpointRequests.unverified(
          told,
          text("wrongFilter", name, ERROR, SAFETY),
          session.form(),
          BreakpointNotVerifiedReason.FAILED);
    }
    return told;
  }

  /** Has the robot of the session know. */
  void apply() {
    session
        .debuggee()
        .filter(each -> !each.arguments().noDebug())
        .ifPresent(
            each -> {
              boolean errors = wanted.contains(ERROR);
              each.run().stopAtSafetyStops(wanted.contains(SAFETY));
              var _ =
                  each.run()
                      .ask(
                          debugger -> {
                            debugger.stopOnErrors(errors);
                            return true;
                          });
            });
  }
}
