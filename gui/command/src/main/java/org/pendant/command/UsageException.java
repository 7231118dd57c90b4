package org.pendant.command;

import org.pendant.command.text.CommandLanguage;

/**
 * Usage error: the command line asks for something that cannot be; carries no stack trace, it is no
 * fault.
 */
final class UsageException extends Exception {
  private static final long serialVersionUID = 1L;

  /**
   * @param message what was given and what was expected
   */
  UsageException(String message) {
    super(message, null, false, false);
  }

  /** What others have refused, in the language of the command line. */
  static UsageException fromEnglish(Exception refused) {
    return new UsageException(CommandLanguage.shown(refused.getMessage()));
  }
}
