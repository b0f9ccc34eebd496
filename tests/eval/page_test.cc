// The report's pages in a real browser: they load without a complaint, and their controls work. The
// browser runs a script that is added to a copy of the page, uses the controls and leaves what it
// saw in the document.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "eval/run_program.h"

namespace walkgraph {
namespace {

using testing::HasSubstr;
using testing::Not;

const std::string kSurvey = std::string(WALKGRAPH_SOURCE_DIR) + "/data/samples/survey";
const std::string kTest = std::string(WALKGRAPH_SOURCE_DIR) + "/data/samples/test";

bool HasBrowser() { return std::system("command -v chromium >/dev/null") == 0; }

struct Visit {
  std::string document;  // as it is after the script
  std::string console;   // what the browser logged
};

// Opens a copy of `page` with `script` at its end, on an empty profile.
Visit Open(const std::string& page, const std::string& script) {
  const std::string copy = page + ".tried.html", dir = FreshPath("profile");
  std::string html = ReadText(page);
  html.insert(html.rfind("</body>"), "<script>" + script + "</script>");
  std::ofstream(copy) << html;
  const std::string command =
      "timeout 60 chromium --headless --no-sandbox --disable-gpu --enable-logging=stderr "
      "--user-data-dir='" +
      dir + "' --dump-dom 'file://" + copy + "' >'" + copy + ".dom' 2>'" + copy + ".log'";
  EXPECT_EQ(std::system(command.c_str()), 0);
  return {ReadText(copy + ".dom"), ReadText(copy + ".log")};
}

TEST(Page, OfAnEvaluationSortsSlidesAndTurnsDark) {
  if (!HasBrowser()) GTEST_SKIP() << "no chromium";
  const std::string out = FreshPath("out"), page = FreshPath("page.html");
  ASSERT_EQ(RunWalkgraph({"evaluate", "--train=" + kSurvey, "--test=" + kTest, "--out=" + out,
                          "--methods=wknn,viterbi,batch"})
                .exit_code,
            0);
  ASSERT_EQ(RunWalkgraph({"report", out, "--out=" + page}).exit_code, 0);
  const std::string beside = page.substr(0, page.rfind('.'));
  const std::string name = out.substr(out.rfind('/') + 1);
  EXPECT_THAT(ReadText(beside + "/tables/" + name + ".csv"), HasSubstr("\nbatch,4,34,"));
  EXPECT_THAT(ReadText(beside + "/tables/" + name + ".tex"), HasSubstr("all\\_walks & walks"));
  const Visit visit = Open(page, R"js(
    const seen = [];
    const first = () => document.querySelector('#score-table tbody td').textContent.trim();
    const before = first();
    [...document.querySelectorAll('#score-table th button')]
        .find((b) => b.textContent.startsWith('mean m')).click();
    seen.push('sorted ' + (first() !== before));
    const time = document.getElementById('time');
    const clock = document.getElementById('clock');
    const begin = clock.textContent;
    time.value = Number(time.max) / 2;
    time.dispatchEvent(new Event('input'));
    seen.push('slid ' + (clock.textContent !== begin));
    const walk = document.getElementById('walk').value;
    document.getElementById('next').click();
    seen.push('chose ' + (document.getElementById('walk').value !== walk));
    const theme = document.documentElement.dataset.theme;
    document.getElementById('theme').click();
    seen.push('turned ' + (document.documentElement.dataset.theme !== theme));
    seen.push('curve ' + (document.querySelectorAll('#cdf canvas').length));
    seen.push('figures ' + document.querySelectorAll('#figure-list svg').length);
    document.body.dataset.seen = seen.join('; ');
  )js");
  EXPECT_THAT(visit.document,
              HasSubstr("sorted true; slid true; chose true; turned true; curve 1; figures 4"));
  EXPECT_THAT(visit.console, Not(HasSubstr("CONSOLE")));
}

TEST(Page, OfAStudySortsAndTurnsDark) {
  if (!HasBrowser()) GTEST_SKIP() << "no chromium";
  const std::string out = FreshPath("out"), page = FreshPath("page.html");
  ASSERT_EQ(RunWalkgraph({"ablate", "--dataset=" + kSurvey, "--out=" + out, "--folds=2",
                          "--factors=step,fingerprint"})
                .exit_code,
            0);
  ASSERT_EQ(RunWalkgraph({"report", out, "--out=" + page}).exit_code, 0);
  const Visit visit = Open(page, R"js(
    const means = () => [...document.querySelector('table.sortable').tBodies[0].rows]
        .map((row) => Number(row.cells[3].textContent));
    const button = document.querySelectorAll('table.sortable th button')[3];
    button.click();
    const up = means();
    button.click();
    const down = means();
    const rises = up.every((v, i) => i === 0 || v >= up[i - 1]) && up[0] < up[3];
    const falls = down.every((v, i) => i === 0 || v <= down[i - 1]);
    const theme = document.documentElement.dataset.theme;
    document.getElementById('theme').click();
    document.body.dataset.seen = `rows ${up.length}; rises ${rises}; falls ${falls}; ` +
        `turned ${document.documentElement.dataset.theme !== theme}`;
  )js");
  EXPECT_THAT(visit.document, HasSubstr("rows 4; rises true; falls true; turned true"));
  EXPECT_THAT(visit.console, Not(HasSubstr("CONSOLE")));
}

TEST(Page, OfOneWalkExplainsItAndFollowsTheSlider) {
  if (!HasBrowser()) GTEST_SKIP() << "no chromium";
  const std::string out = FreshPath("out"), page = FreshPath("page.html");
  ASSERT_EQ(RunWalkgraph({"evaluate", "--train=" + kSurvey, "--test=" + kTest, "--out=" + out,
                          "--methods=wknn,batch"})
                .exit_code,
            0);
  const ProgramResult misspelt = RunWalkgraph({"report", out, "--walk=walk_00", "--out=" + page});
  EXPECT_EQ(misspelt.exit_code, 2);
  EXPECT_THAT(misspelt.output, HasSubstr("did you mean \"walk_01\"?"));
  ASSERT_EQ(RunWalkgraph({"report", out, "--walk=walk_02", "--out=" + page}).exit_code, 0);
  const Visit visit = Open(page, R"js(
    const inFigures = () => [...document.querySelectorAll('svg[data-time] .moment')]
        .map((path) => path.getAttribute('d')).join();
    const inCharts = () => [...document.querySelectorAll('#courses .moment')]
        .map((mark) => mark.style.left).join();
    const begin = [inFigures(), inCharts()];
    const time = document.getElementById('time');
    time.value = Number(time.max) / 2;
    time.dispatchEvent(new Event('input'));
    const followed = [inFigures(), inCharts()].every((now, i) => begin[i] !== '' && now !== begin[i]);
    // A click at a quarter of a chart takes the slider there.
    const over = document.querySelector('#courses .u-over'), box = over.getBoundingClientRect();
    const at = {clientX: box.left + box.width / 4, clientY: box.top + 5, bubbles: true};
    for (const name of ['mousedown', 'mouseup', 'click']) over.dispatchEvent(new MouseEvent(name, at));
    const led = Math.abs(time.value / time.max - 0.25) < 0.01;
    const key = document.querySelector('#courses .u-legend .u-series:nth-child(2) th');
    key.dispatchEvent(new KeyboardEvent('keydown', {key: 'Enter'}));
    const off = key.closest('tr').classList.contains('u-off');
    const notes = document.getElementById('notes').textContent;
    document.body.dataset.seen = `followed ${followed}; led ${led}; off ${off}; ` +
        `courses ${document.querySelectorAll('#courses canvas').length > 3}; ` +
        `walks ${document.querySelectorAll('#walk option').length}; ` +
        `fit ${/batch: fingerprint, \d+ measurements/.test(notes)}; ` +
        `answer ${/batch: hypothesis from .*, the answer/.test(notes)}`;
  )js");
  EXPECT_THAT(
      visit.document,
      HasSubstr("followed true; led true; off true; courses true; walks 1; fit true; answer true"));
  EXPECT_THAT(visit.console, Not(HasSubstr("CONSOLE")));
}

TEST(Page, RunsOfDifferentInputsAreRefusedByName) {
  const std::string one = FreshPath("one"), other = FreshPath("other"), page = FreshPath("p.html");
  ASSERT_EQ(RunWalkgraph({"evaluate", "--train=" + kSurvey, "--test=" + kTest, "--out=" + one,
                          "--methods=wknn"})
                .exit_code,
            0);
  ASSERT_EQ(RunWalkgraph({"evaluate", "--dataset=" + kSurvey, "--out=" + other, "--folds=2",
                          "--methods=wknn"})
                .exit_code,
            0);
  const ProgramResult refused = RunWalkgraph({"report", one, other, "--out=" + page});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.output, HasSubstr("different recordings"));
  EXPECT_EQ(RunWalkgraph({"report", one, other, "--out=" + page, "--allow_differences"}).exit_code,
            0);
  EXPECT_EQ(RunWalkgraph({"report", one, one, "--out=" + page}).exit_code, 0);
}

}  // namespace
}  // namespace walkgraph
