/**
 * Rules of the cell: what happens by itself between outputs and inputs. Open {@link
 * org.pendant.controller.rule.RuleSetup} first.
 */
package org.pendant.controller.rule;
