/**
 * Static checks of a parsed script before it runs: which part of it is the program, what each name
 * stands for, and what is certainly wrong with it. Open {@link org.pendant.language.check.Checker}
 * first; {@link org.pendant.language.check.Scopes} holds the rules for names that the compiler
 * shares.
 */
package org.pendant.language.check;
