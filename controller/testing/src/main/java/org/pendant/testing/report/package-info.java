/** Reports of tests: what came of them as text for people and for other tools. */
package org.pendant.testing.report;
