package org.pendant.desktop.log;

import java.util.List;
import java.util.OptionalLong;
import java.util.function.LongFunction;
import org.pendant.desktop.unit.PoseForm;

/**
 * Log presenter: what the log screen shows: messages that pass the filter, oldest first, the
 * matches of a search, and whether the newest is followed. Work per message is constant; only a new
 * filter or search looks at all that are kept.
 */
final class LogPresenter {
  /** How many messages are kept. */
  static final int KEPT = 100_000;

  private final LogStore store;
  private final LogPositions shown = new LogPositions();
  private final LogPositions matches = new LogPositions();
  private final LogRuns runs = new LogRuns();
  private LogFilter filter = LogFilter.ALL;
  private TextSearch search = TextSearch.NONE;
  private PoseForm form = PoseForm.STANDARD;
  private long taken;
  private long dropped;
  private long missed;
  private boolean following = true;
  private long pastPosition = Long.MAX_VALUE;

  /** What was selected before the past was looked at. */
  private OptionalLong selectedBefore = OptionalLong.empty();

  private int unread;

  /**
   * How the rows differ from before.
   *
   * @param removed so many went from the top
   * @param added so many came at the bottom
   */
  record Change(int removed, int added) {
    boolean none() {
      return removed == 0 && added == 0;
    }
  }

  LogPresenter() {
    this(KEPT);
  }

  LogPresenter(int kept) {
    store = new LogStore(kept);
  }

  /**
   * Takes what has been written since the last time.
   *
   * @param newest number of the newest message, 0 for none
   * @param since gives the messages after a number that are still there
   */
  Change take(long newest, LongFunction<List<LogLine>> since) {
    if (newest == taken) {
      return new Change(0, 0);
    }
    int before = shown.size();
    long oldest = store.first();
    for (LogLine line : since.apply(taken)) {
      missed += line.number() - taken - 1;
      taken = line.number();
      add(line);
    }
    dropped += store.first() - oldest;
    int removed = shown.dropBelow(store.first());
    matches.dropBelow(store.first());
    int added = shown.size() + removed - before;
    if (!following) {
      unread += added;
    }
    return new Change(Math.min(removed, before), added - Math.max(0, removed - before));
  }

  private void add(LogLine line) {
    store.add(line);
    consider(store.end() - 1, line);
  }

  private void consider(long position, LogLine line) {
    if (filter.accepts(line)) {
      shown.add(position);
      if (search.in(line.in(form).text())) {
        matches.add(position);
      }
    }
  }

  /** Shows others; all rows may be different then. */
  void setFilter(LogFilter wanted) {
    if (!wanted.equals(filter)) {
      filter = wanted;
      lookAgain();
    }
  }

  LogFilter filter() {
    return filter;
  }

  /** Looks for something; rows stay. */
  void setSearch(String wanted) {
    search = new TextSearch(wanted);
    lookAgain();
  }

  /** Where messages come from. */
  LogRuns runs() {
    return runs;
  }

  TextSearch search() {
    return search;
  }

  /** Shows numbers of the safety functions in other units, also in messages of before. */
  void setForm(PoseForm wanted) {
    form = wanted;
    lookAgain();
  }

  PoseForm form() {
    return form;
  }

  private void lookAgain() {
    shown.clear();
    matches.clear();
    for (long each = store.first(); each < store.end(); each++) {
      consider(each, store.at(each));
    }
  }

  /** Empties the screen; the controller's log is untouched. */
  void clear() {
    store.clear();
    shown.clear();
    matches.clear();
    dropped = 0;
    missed = 0;
    unread = 0;
  }

  /** Empties the screen and takes what there is from the first message on. */
  void restart() {
    clear();
    taken = 0;
    pastPosition = Long.MAX_VALUE;
    selectedBefore = OptionalLong.empty();
  }

  /** How many rows there are. */
  int rows() {
    return shown.size();
  }

  /** A message, with numbers in the units that people have chosen. */
  LogLine row(int index) {
    return store.at(shown.get(index)).in(form);
  }

  /** The row of a place given by {@link #positionOf}, or the next that is still shown. */
  int rowAt(long position) {
    return Math.min(shown.firstAtLeast(position), shown.size() - 1);
  }

  /** A name of a row that stays when others come and go. */
  long positionOf(int row) {
    return shown.get(row);
  }

  /** How many rows have what is looked for. */
  int matchCount() {
    return matches.size();
  }

  /** The how manieth match row {@code row} is, from 1; 0 if it is none. */
  int matchNumber(int row) {
    if (row < 0 || row >= shown.size()) {
      return 0;
    }
    long position = shown.get(row);
    int index = matches.firstAtLeast(position);
    return index < matches.size() && matches.get(index) == position ? index + 1 : 0;
  }

  /** The row of the next match below {@code row}, from the top again at the end; -1 for none. */
  int nextMatch(int row) {
    if (matches.size() == 0) {
      return -1;
    }
    long from = positionAt(row + 1);
    return shown.firstAtLeast(matches.get(matches.firstAtLeast(from) % matches.size()));
  }

  /** The row of the next match above {@code row}, from the bottom again; -1 for none. */
  int previousMatch(int row) {
    if (matches.size() == 0) {
      return -1;
    }
    int index = matches.firstAtLeast(positionAt(row));
    return shown.firstAtLeast(matches.get(Math.floorMod(index - 1, matches.size())));
  }

  /** Where a row is; before all and behind all for rows that there are not. */
  private long positionAt(int row) {
    if (row < 0) {
      return store.first();
    }
    return row < shown.size() ? shown.get(row) : store.end();
  }

  /**
   * Looks at a time of what the present controller did.
   *
   * @param selectedRow -1 for none; {@link #lookAtNow} gives it back
   * @return the row that was the newest then; -1 if none was there
   */
  int lookAt(double timeS, int selectedRow) {
    if (pastPosition == Long.MAX_VALUE) {
      selectedBefore =
          selectedRow < 0 ? OptionalLong.empty() : OptionalLong.of(shown.get(selectedRow));
    }
    int row = shown.size() - 1;
    double later = Double.POSITIVE_INFINITY;
    while (row >= 0 && row(row).timeS() > timeS && row(row).timeS() <= later) {
      later = row(row).timeS();
      row--;
    }
    // Where time goes up backwards, the log of another controller begins.
    boolean found = row >= 0 && row(row).timeS() <= timeS;
    pastPosition = row >= 0 ? shown.get(row) : store.first() - 1;
    return found ? row : -1;
  }

  /**
   * Looks at now again.
   *
   * @return the row that was selected before; -1 if there was none, or it has gone
   */
  int lookAtNow() {
    pastPosition = Long.MAX_VALUE;
    OptionalLong before = selectedBefore;
    selectedBefore = OptionalLong.empty();
    if (before.isEmpty() || shown.size() == 0) {
      return -1;
    }
    int row = rowAt(before.getAsLong());
    return shown.get(row) == before.getAsLong() ? row : -1;
  }

  /** Whether a row came later than what is looked at. */
  boolean later(int row) {
    return row >= 0 && row < shown.size() && shown.get(row) > pastPosition;
  }

  /** Whether the newest row is kept in sight. */
  boolean following() {
    return following;
  }

  /** Follows, or no longer does. */
  void follow(boolean wanted) {
    following = wanted;
    if (wanted) {
      unread = 0;
    }
  }

  /** How many rows came since the newest is no longer followed. */
  int unread() {
    return unread;
  }

  /** How many are no longer here because the memory for them is bounded. */
  long dropped() {
    return dropped;
  }

  /** How many were gone before they were asked for. */
  long missed() {
    return missed;
  }

  /** How many are kept, whether shown or not. */
  long kept() {
    return store.end() - store.first();
  }
}
